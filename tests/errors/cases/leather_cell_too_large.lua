return scene {
  objects = {
    generator.leather {
      preset = "coarse_grain",
      size = 0.05,
      cell = 0.02,
    },
  },
}
