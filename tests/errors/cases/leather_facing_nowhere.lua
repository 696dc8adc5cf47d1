return scene {
  objects = {
    generator.leather { resolution = 16, cell = 0.005, shape = mesh.sphere {},
      facing = { 0, 0, 0 } },
  },
}
