return scene {
  objects = {
    object { shape = mesh.box {}, material = material.matte { color = { 2, 0, 0 } } },
    object { shape = mesh.box {}, material = material.matte { palette = { { 1, 0, 0 }, { 0, 1 } } } },
    object { shape = mesh.box {}, material = material.matte { palette = {} } },
  },
}
