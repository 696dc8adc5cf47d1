return scene {
  objects = {
    generator.fibres {
      target = mesh.sphere { radius = 0.1 },
      length = { 0.1, 0.05 },
    },
  },
}
