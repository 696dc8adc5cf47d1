return scene {
  objects = {
    generator.fibres {
      target = mesh.sphere { radius = 0.1 },
      count = 4, length = 0.4, contact = false,
    },
  },
}
