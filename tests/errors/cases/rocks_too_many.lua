return scene {
  objects = {
    generator.rocks {
      domain = region.rectangle { width = 3, depth = 3 },
      smallest = 0.0001, largest = 0.0002
    },
  },
}
