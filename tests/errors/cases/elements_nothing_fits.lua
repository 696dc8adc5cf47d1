return scene {
  objects = {
    generator.elements {
      domain = region.rectangle { width = 1, depth = 0.3 },
      inside = "whole",
      scale_by = 2,
      components = {
        { shape = region.star { radius = 0.02 } },
        { shape = region.rectangle { width = 0.2, depth = 0.02 } },
      },
    },
  },
}
