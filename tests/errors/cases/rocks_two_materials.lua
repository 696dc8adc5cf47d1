return scene {
  objects = {
    generator.rocks {
      domain = region.rectangle { width = 3, depth = 3 },
      material = material.matte {}, materials = { material.matte {} }, smallest = 0.1, largest = 0.3
    },
  },
}
