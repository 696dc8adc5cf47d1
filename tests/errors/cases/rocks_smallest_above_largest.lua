return scene {
  objects = {
    generator.rocks {
      domain = region.rectangle { width = 3, depth = 3 },
      smallest = 0.4, largest = 0.3
    },
  },
}
