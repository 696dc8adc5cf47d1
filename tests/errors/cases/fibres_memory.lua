return scene {
  objects = {
    generator.fibres {
      target = mesh.sphere { radius = 0.1 },
      count = 10000000, segments = 256, length = 0.1, radius = 0.00001,
    },
  },
}
