return scene {
  objects = {
    generator.elements {
      surface = mesh.sphere {},
      relax = 20,
      components = { { shape = mesh.rice {} } },
    },
  },
}
