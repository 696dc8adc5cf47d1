return scene {
  objects = {
    generator.rocks {
      domain = region.rectangle { width = 3, depth = 3 },
      smallest = 0.1, largest = 0.3, density = 0
    },
  },
}
