return scene {
  objects = {
    generator.layout {
      domain = region.rectangle {},
      components = { { shape = mesh.box {} } },
      scale = { 2, 1 },
      rotation = { 0, "x" },
    },
  },
}
