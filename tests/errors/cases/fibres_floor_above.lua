return scene {
  objects = {
    generator.fibres {
      target = mesh.sphere { radius = 0.1 },
      gravity = true,
      floor = 1,
    },
  },
}
