return scene {
  objects = {
    object { shape = mesh.file { path = "parts/triangle.obj", scale = 0.001 } },
    object { shape = mesh.sphere { position = { 0, 1, 0 }, teeth = 12 } },
    generator.layout {
      name = "leaves",
      domain = region.rectangle { width = 1, depth = 1 },
      components = { { shape = mesh.box { margin = 0.01 }, picture = "leaf.svg" } },
    },
  },
}
