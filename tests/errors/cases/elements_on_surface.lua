return scene {
  objects = {
    generator.elements {
      surface = mesh.sphere {},
      direction = 30,
      components = { { shape = mesh.rice {} } },
    },
  },
}
