return scene {
  objects = {
    generator.fibres {
      target = mesh.sphere { radius = 0.1 },
      theta = { 10, -10 },
    },
  },
}
