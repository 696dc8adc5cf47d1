return scene {
  objects = {
    generator.elements {
      domain = region.circle { radius = 2 },
      components = {
        { shape = region.star { radius = 0.1 }, length = 0.3 },
        { shape = region.star { radius = 0.1 } },
      },
    },
  },
}
