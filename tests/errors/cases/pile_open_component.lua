return scene {
  objects = {
    generator.pile {
      target = mesh.sphere {},
      components = { { shape = mesh.plane { size = 0.1 } } },
    },
  },
}
