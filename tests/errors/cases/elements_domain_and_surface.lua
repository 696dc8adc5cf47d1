return scene {
  objects = {
    generator.elements {
      domain = region.rectangle {},
      surface = mesh.sphere {},
      components = { { shape = mesh.rice {} } },
    },
  },
}
