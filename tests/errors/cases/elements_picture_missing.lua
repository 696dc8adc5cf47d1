return scene {
  objects = {
    generator.elements {
      domain = region.circle { radius = 2 },
      components = { { picture = "no_such_leaf.svg", size = 0.1 } },
    },
  },
}
