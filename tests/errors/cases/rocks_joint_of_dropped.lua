return scene {
  objects = {
    generator.rocks {
      domain = region.rectangle { width = 3, depth = 3 },
      joint = 0.01, smallest = 0.1, largest = 0.3
    },
  },
}
