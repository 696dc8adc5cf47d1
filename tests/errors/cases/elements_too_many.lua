return scene {
  objects = {
    generator.elements {
      domain = region.rectangle { width = 1000, depth = 1000 },
      components = { { shape = region.circle { radius = 0.0001 } } },
    },
  },
}
