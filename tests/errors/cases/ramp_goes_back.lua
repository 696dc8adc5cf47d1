return scene {
  objects = {
    object { shape = mesh.sphere {}, material = material.matte { color = procedural.ramp { from = { 0, 0, 0 }, to = { 1, 0, 0 }, stops = { { at = 0.5, color = 0.5 }, { at = 0.2, color = 0.1 } } } } },
  },
}
