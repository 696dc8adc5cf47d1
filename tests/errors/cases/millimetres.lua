return scene {
  objects = {
    object { shape = mesh.banana { length = 180 } },
  },
}
