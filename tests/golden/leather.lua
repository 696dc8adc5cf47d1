-- Coarse leather over a ball and as a flat swatch, in a low light that shows the relief.
local hide = material.plastic { color = { 0.3, 0.12, 0.05 }, roughness = 0.4 }

return scene {
  film = { width = 160, height = 90, samples = 64, clamp = 4 },
  camera = camera.perspective { from = { 0, 0.12, 0.26 }, at = { 0, 0.016, 0 }, fov = 19 },
  lights = {
    light.sky { strength = 0.4 },
    light.area { position = { -0.3, 0.16, 0.1 }, at = { 0, 0.01, 0 }, size = { 0.1, 0.1 }, strength = 30 },
  },
  objects = {
    generator.leather {
      preset = "coarse_grain", size = 0.05, cell = 0.005, resolution = 256, triangles = 120000, seed = 2,
      shape = mesh.sphere { radius = 0.024 }, facing = { 0, 0.4, 1 }, material = hide, position = { -0.032, 0, 0 },
    },
    generator.leather {
      preset = "reptile", size = 0.05, resolution = 256, triangles = 120000, thickness = 0.002, seed = 5,
      material = hide, position = { 0.032, 0.004, 0 }, rotation = { 30, -10, 0 },
    },
    object { shape = mesh.plane { size = 2 }, material = material.matte { color = { 0.4, 0.4, 0.42 } } },
  },
}
