return scene {
  objects = {
    generator.elements {
      domain = region.circle { radius = 2 },
      components = { { shape = region.star { radius = 0.1 }, weight = 0, length = -1, scale = 3 } },
      mix = "evenly",
    },
  },
}
