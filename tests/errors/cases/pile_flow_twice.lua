return scene {
  objects = {
    generator.pile {
      target = mesh.sphere { radius = 0.02 },
      components = { { shape = mesh.rice {} } },
      frame = "flow",
      flow = { direction = { 1, 0, 0 }, about = { 0, 1, 0 } },
    },
  },
}
