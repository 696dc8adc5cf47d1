return scene { objects = {
  generator.layout {
    domain = region.circle { radius = 1 },
    components = { { shape = region.circle { radius = 0.1 }, material = "file" } },
  },
} }
