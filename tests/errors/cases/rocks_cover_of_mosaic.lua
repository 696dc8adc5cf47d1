return scene {
  objects = {
    generator.rocks {
      domain = region.rectangle { width = 3, depth = 3 },
      method = "mosaic", cover = 0.5, sizes = { { radius = 0.1, share = 0.5 } }
    },
  },
}
