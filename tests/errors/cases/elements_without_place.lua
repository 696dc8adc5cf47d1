return scene {
  objects = {
    generator.elements {
      components = { { shape = mesh.rice {} } },
    },
  },
}
