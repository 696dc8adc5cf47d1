return scene {
  film = { width = 3 
  objects = {},
}
