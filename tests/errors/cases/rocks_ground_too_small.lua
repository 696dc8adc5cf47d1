return scene {
  objects = {
    generator.rocks {
      domain = region.rectangle { width = 3, depth = 3 },
      ground = mesh.plane { size = 2 }, smallest = 0.1, largest = 0.3
    },
  },
}
