return scene {
  objects = {
    generator.rocks {
      domain = region.rectangle { width = 3, depth = 3 },
      slope = 10, ground = mesh.plane { size = 4 }, smallest = 0.1, largest = 0.3
    },
  },
}
