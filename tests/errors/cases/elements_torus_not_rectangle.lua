return scene {
  objects = {
    generator.elements {
      domain = region.circle { radius = 2 },
      torus = true,
      components = { { shape = region.star { radius = 0.1 } } },
    },
  },
}
