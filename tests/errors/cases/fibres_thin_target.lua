return scene {
  objects = {
    generator.fibres {
      target = mesh.box { width = 0.2, depth = 0.2, height = 0.002, rounding = 0 }, radius = 0.0015,
    },
  },
}
