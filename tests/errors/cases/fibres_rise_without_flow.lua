return scene {
  objects = {
    generator.fibres {
      target = mesh.sphere { radius = 0.1 },
      flow_rise = -90,
    },
  },
}
