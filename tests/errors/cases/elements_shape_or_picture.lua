return scene {
  objects = {
    generator.elements {
      domain = region.circle { radius = 2 },
      components = { { weight = 2 } },
    },
  },
}
