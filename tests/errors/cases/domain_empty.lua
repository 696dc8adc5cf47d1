return scene {
  objects = {
    generator.layout {
      domain = region.polygon {
        points = { { 0, 0 }, { 1, 0 }, { 2, 0 } },
      },
      components = { { shape = mesh.box {} } },
    },
    generator.layout {
      domain = region.polygon { points = {} },
      components = {},
    },
  },
}
