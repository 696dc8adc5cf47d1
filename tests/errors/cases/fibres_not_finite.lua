return scene {
  objects = {
    generator.fibres {
      target = mesh.sphere { radius = 0.1 },
      radius = 0 / 0, length = 1 / 0,
    },
  },
}
