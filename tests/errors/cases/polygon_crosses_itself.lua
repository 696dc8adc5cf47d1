return scene {
  objects = {
    generator.layout {
      domain = region.polygon {
        points = { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } },
      },
      components = { { shape = mesh.box {} } },
    },
  },
}
