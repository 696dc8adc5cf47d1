return scene {
  objects = {
    generator.elements {
      surface = mesh.sphere {},
      torus = true,
      components = { { shape = mesh.rice {} } },
    },
  },
}
