return scene {
  objects = {
    generator.pile {
      target = mesh.plane { size = 100 },
      components = { { shape = mesh.rice {} } },
      spacing = 0.1,
    },
  },
}
