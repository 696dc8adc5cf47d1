return scene {
  objects = {
    generator.leather { resolution = 16, triangles = 3000, cell = 0.003,
                        shape = mesh.box { width = 0.05, rounding = 0, uvs = "even" } },
    generator.leather { resolution = 16, shape = mesh.sphere { radius = 50 } },
  },
}
