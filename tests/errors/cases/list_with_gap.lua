return scene {
  objects = { object { shape = mesh.box {} }, nil, object { shape = mesh.box {} } },
}
