return scene {
  camera = camera.perspective { from = { 0, 1, 2 }, at = { 0, 0, 0 } },
  objects = {
    object { shape = mesh.box {}, material = material.matte { color = procedural.marble { filler = { 2, 0, 0 } } } },
  },
}
