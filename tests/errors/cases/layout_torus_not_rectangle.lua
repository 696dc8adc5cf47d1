return scene {
  objects = {
    generator.layout {
      domain = region.circle { radius = 1 },
      torus = true,
      components = { { shape = region.circle { radius = 0.01 } } },
    },
  },
}
