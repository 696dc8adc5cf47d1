return scene {
  objects = {
    generator.fibres {
      target = mesh.sphere { radius = 0.1 },
      count = 40, length = 0.1, radius = 0.01, segments = 4, contact = false,
    },
  },
}
