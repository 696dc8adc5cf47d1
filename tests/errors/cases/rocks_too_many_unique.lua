return scene {
  objects = {
    generator.rocks {
      domain = region.rectangle { width = 3, depth = 3 },
      unique = true, triangles = 20480, smallest = 0.01, largest = 0.02
    },
  },
}
