return scene {
  film = { 3, width = 10 },
  lights = { [0] = light.sky {} },
  objects = { object { shape = mesh.box {} } },
}
