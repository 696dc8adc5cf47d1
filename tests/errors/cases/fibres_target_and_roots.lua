return scene {
  objects = {
    generator.fibres {
      target = mesh.sphere { radius = 0.1 },
      roots = mesh.sphere { radius = 0.1 },
    },
  },
}
