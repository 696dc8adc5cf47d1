return scene {
  objects = {
    object { shape = mesh.terrain { height = 0.1, width = 0.01, depth = 50 } },
  },
}
