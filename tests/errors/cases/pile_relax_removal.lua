return scene {
  objects = {
    generator.pile {
      target = mesh.sphere { radius = 0.02 },
      components = { { shape = mesh.rice {} } },
      method = "relax", removal = 0,
    },
  },
}
