return scene {
  objects = {
    object { shape = mesh.lathe { profile = { { x = 0, z = 1 }, { x = 1, z = 2 } } },
             position = { x = 1, y = 2, z = 3 },
             material = material.matte { color = { r = 1, g = 0, b = 0 } } },
  },
}
