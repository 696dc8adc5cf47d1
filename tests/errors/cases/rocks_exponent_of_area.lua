return scene {
  objects = {
    generator.rocks {
      domain = region.rectangle { width = 3, depth = 3 },
      distribution = "area", cover = 0.2, exponent = 2, smallest = 0.1, largest = 0.3
    },
  },
}
