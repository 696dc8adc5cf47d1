return scene {
  objects = {
    generator.elements {
      domain = region.circle { radius = 2 },
      mix = "random",
      components = {
        { shape = region.star { radius = 0.1 } },
        { shape = region.star { radius = 0.1 }, rotation = { 0, 72 } },
      },
    },
  },
}
