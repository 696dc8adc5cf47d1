return scene {
  objects = {
    generator.rocks {
      method = "mosaic", sizes = { { radius = 0.2, share = 1 } },
      domain = region.polygon { points = { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 1, 0.5 }, { 0, 2 } } },
    },
  },
}
