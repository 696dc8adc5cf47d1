return scene {
  objects = {
    generator.fibres { target = mesh.sphere { radius = 0.05 }, position = { 0, 0.05, 0 }, count = 50,
                       container = mesh.sphere { radius = 0.1 } },
  },
}
