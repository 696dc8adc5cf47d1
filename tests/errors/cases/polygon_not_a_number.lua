local hole = 0 / 0
return scene {
  objects = {
    generator.layout {
      domain = region.polygon { points = {
        { 0, 0 },
        { 1, hole },
        { 1, 1 },
      } },
      components = { { shape = mesh.box {} } },
    },
  },
}
