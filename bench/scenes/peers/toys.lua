-- Toys of plastic and metal on a matte floor, under sun and sky.
local red, yellow, green, blue = srgb("#cf3a2e"), srgb("#eebb35"), srgb("#4f9a4a"), srgb("#2f62a8")
local candy = material.plastic { palette = { red, yellow, green, blue }, roughness = 0.3 }
local painted = material.plastic { palette = { blue, green, red, yellow }, roughness = 0.4 }

return scene {
  film = { width = 320, height = 180, depth = 8, filter = "box", radius = 0.5 },
  camera = camera.perspective { from = { 0.15, 1.12, 1.9 }, at = { 0, 0, 0.06 }, fov = 36 },
  lights = {
    light.sky { zenith = { 0.2, 0.28, 0.44 }, horizon = { 0.5, 0.52, 0.55 }, ground = { 0.17, 0.15, 0.14 } },
    light.sun { direction = { -1.2, 1, -0.3 }, angle = 2, color = { 1, 0.9, 0.76 }, strength = 4 },
  },
  objects = {
    generator.layout {
      method = "fill_gap", seed = 7,
      domain = region.circle { radius = 1.15, segments = 96 },
      components = {
        { shape = mesh.star { radius = 0.065 }, material = candy, weight = 2 },
        { shape = mesh.ring { radius = 0.07 }, material = candy, weight = 2 },
        { shape = mesh.block { size = 0.085 }, material = painted, weight = 2 },
        { shape = mesh.duck { length = 0.13 }, material = material.plastic { color = yellow, roughness = 0.3 } },
        { shape = mesh.tree { height = 0.17 }, material = painted },
        { shape = mesh.jack { size = 0.075 }, material = material.metal { preset = "brass", roughness = 0.4 } },
        { shape = mesh.gear { radius = 0.06 }, material = material.metal { preset = "aluminium", roughness = 0.3 } },
        { shape = mesh.sphere { radius = 0.045 }, material = material.metal { preset = "copper", roughness = 0.35 } },
      },
      rotation = { 0, 360 }, scale = { 0.85, 1.15 },
    },
    object { shape = mesh.plane { size = 14 }, material = material.matte { color = srgb("#9c7350") } },
  },
}
