return scene {
  objects = { object { shape = mesh.box {} } },
  film = { filter = "\xff" },
}
