return scene {
  objects = {
    generator.fibres {
      target = mesh.plane { size = 1 },
    },
  },
}
