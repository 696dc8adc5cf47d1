return scene {
  objects = {
    generator.pile {
      target = mesh.sphere {},
      components = { { shape = mesh.rice {}, thickness = mm(1) } },
    },
  },
}
