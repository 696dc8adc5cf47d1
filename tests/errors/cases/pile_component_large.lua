return scene {
  objects = {
    generator.pile {
      target = mesh.sphere { radius = 0.1 },
      components = {
        { shape = mesh.box { width = 0.1 } },
        { shape = mesh.box { width = 0.4 } },
      },
    },
  },
}
