return scene {
  objects = {
    generator.pile {
      target = mesh.sphere { radius = 0.02 },
      components = { { shape = mesh.rice {} } },
      method = "thesis",
      cover = 0.9,
    },
  },
}
