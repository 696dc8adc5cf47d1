return scene {
  objects = {
    generator.rocks {
      domain = region.rectangle { width = 3, depth = 3 },
      method = "paper", ground = mesh.plane { size = 4 }, sizes = { { radius = 0.1, share = 0.7 } }
    },
  },
}
