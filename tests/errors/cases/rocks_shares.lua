return scene {
  objects = {
    generator.rocks {
      domain = region.rectangle { width = 3, depth = 3 },
      sizes = { { radius = 0.1, share = 0.7 }, { radius = 0.05, share = 0.4 } }
    },
  },
}
