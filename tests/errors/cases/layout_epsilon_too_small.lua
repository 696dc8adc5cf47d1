return scene {
  objects = {
    generator.layout {
      method = "saturated",
      epsilon = 1e-6,
      domain = region.rectangle { width = 3, depth = 3 },
      components = { { shape = region.star { radius = 0.2 } } },
    },
  },
}
