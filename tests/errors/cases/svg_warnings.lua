return scene {
  objects = {
    generator.layout { domain = region.svg { path = "parts/left_out.svg", size = 1 },
                       components = { { shape = mesh.box { width = 0.01 } } }, max_count = 1 },
  },
}
