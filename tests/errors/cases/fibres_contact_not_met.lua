return scene {
  objects = {
    generator.fibres {
      target = mesh.sphere { radius = 0.1 },
      count = 60, length = 0.1, radius = 0.003, segments = 8, max_iterations = 1,
    },
  },
}
