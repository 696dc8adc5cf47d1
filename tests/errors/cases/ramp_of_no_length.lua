return scene {
  objects = {
    object { shape = mesh.sphere {}, material = material.matte { color = procedural.ramp { from = { 0, 0, 0 }, to = { 0, 0, 0 }, stops = { { at = 0, color = 0.5 } } } } },
  },
}
