return scene {
  objects = {
    generator.rocks {
      domain = region.rectangle { width = 3, depth = 3 },
      method = "mosaic", sizes = { { radius = 1.5, share = 0.1 } }
    },
  },
}
