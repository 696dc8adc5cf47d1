return scene {
  objects = {
    generator.layout {
      domain = region.rectangle { width = 1, depth = 3 },
      density = field.gradient { from = {0, 0}, to = {1, 0}, low = 0, high = 2 },
      components = { { shape = region.circle { radius = 0.1 }, margin = -0.01 } },
    },
  },
}
