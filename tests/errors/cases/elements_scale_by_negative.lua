return scene {
  objects = {
    generator.elements {
      domain = region.rectangle { width = 3, depth = 3 },
      scale_by = field.gradient { from = {-1, 0}, to = {1, 0}, low = -1, high = 2 },
      components = { { shape = region.star { radius = 0.2 } } },
    },
  },
}
