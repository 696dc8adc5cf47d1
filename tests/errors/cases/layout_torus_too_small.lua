return scene {
  objects = {
    generator.layout {
      domain = region.rectangle { width = 1, depth = 3 },
      torus = true,
      components = { { shape = region.circle { radius = 0.05 } },
                     { shape = region.rectangle { width = 0.6, depth = 0.6 } } },
    },
  },
}
