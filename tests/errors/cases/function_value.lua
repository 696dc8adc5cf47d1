return scene {
  film = { width = function() end },
  lights = { coroutine.create(print) },
  objects = { print },
}
