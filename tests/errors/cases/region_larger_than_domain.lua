return scene {
  objects = {
    generator.layout {
      domain = region.rectangle { width = 0.1, depth = 0.1 },
      inside = "whole",
      components = {
        { shape = region.circle { radius = 0.01 } },
        { shape = region.rectangle { width = 1, depth = 1 } },
      },
    },
  },
}
