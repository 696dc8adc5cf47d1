-- Elements evenly spread in a region with a hole, turned by a field.
local ring = "M -0.62 0 A 0.62 0.62 0 1 1 0.62 0 A 0.62 0.62 0 1 1 -0.62 0 Z M -0.2 0 A 0.2 0.2 0 1 1 0.2 0 A 0.2 0.2 0 1 1 -0.2 0 Z"
local leaf = region.path { d = "M 0 -1 C 0.5 -0.5 0.45 0.4 0 1 C -0.45 0.4 -0.5 -0.5 0 -1 Z", size = 0.16 }

return scene {
  film = { width = 160, height = 90, samples = 64, clamp = 4 },
  camera = camera.perspective { from = { 0, 1.1, 0.9 }, at = { 0, 0, 0.05 }, fov = 50 },
  lights = { light.sky { strength = 0.6 }, light.sun { direction = { -1, 1.2, 0.4 }, angle = 3 } },
  objects = {
    generator.elements {
      domain = region.path { d = ring, fill_rule = "evenodd" },
      components = {
        { shape = mesh.extrude { outline = leaf, height = 0.012 }, weight = 2, material = material.plastic { palette = { { color = { 0.15, 0.4, 0.08 } }, { color = { 0.5, 0.35, 0.05 } } } } },
        { shape = mesh.sphere { radius = 0.03 }, material = material.plastic { color = { 0.7, 0.1, 0.08 }, roughness = 0.15 } },
      },
      rotation = { -40, 40 }, seed = 3,
    },
    object { shape = mesh.plane { size = 6 }, material = material.matte { color = { 0.45, 0.43, 0.4 } } },
  },
}
