return scene {
  objects = {
    generator.rocks {
      domain = region.rectangle { width = 3, depth = 3 },
      axes = { 0.5, 0.05 }, smallest = 0.1, largest = 0.3
    },
  },
}
