return scene {
  objects = {
    generator.rocks { domain = region.rectangle { width = 3, depth = 3 } },
  },
}
