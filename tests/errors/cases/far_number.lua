return scene {
  camera = camera.perspective { from = { 0, 1e10, 0 } },
  objects = {
    object {
      shape = mesh.sphere {}, position = { 1e30, 0, 0 }, rotation = { 0, -1e12, 0 }, scale = { 1e-20, 1, 1 },
      material = material.matte { color = procedural.wood { origin = { 1e300, 0, 0 } } },
    },
  },
}
