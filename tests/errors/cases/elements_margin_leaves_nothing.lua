return scene {
  objects = {
    generator.elements {
      domain = region.circle { radius = 2 },
      components = { { shape = region.rectangle { width = 0.2, depth = 0.02 }, margin = -0.1 } },
    },
  },
}
