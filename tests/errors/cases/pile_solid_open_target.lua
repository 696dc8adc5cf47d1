return scene {
  objects = {
    generator.pile {
      target = mesh.plane {},
      components = { { shape = mesh.rice {} } },
      fill = "solid",
    },
  },
}
