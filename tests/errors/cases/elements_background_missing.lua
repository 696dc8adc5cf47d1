return scene {
  objects = {
    generator.elements {
      domain = region.circle { radius = 2 },
      components = { { shape = region.star { radius = 0.1 } } },
      background = "no_such_paper.png",
    },
  },
}
