-- Noodles that fell into a bowl and came to rest on each other.
local pile = include("parts/pile.lua")
local bowl = mesh.lathe {
  profile = {
    { 0, 0.006 }, { 0.05, 0.006 }, { 0.05, 0.006 }, { 0.053, 0 }, { 0.053, 0 }, { 0.062, 0 }, { 0.062, 0 }, { 0.066, 0.006 },
    { 0.105, 0.024 }, { 0.137, 0.06 }, { 0.147, 0.098 }, { 0.147, 0.104 }, { 0.143, 0.106 }, { 0.138, 0.101 },
    { 0.127, 0.063 }, { 0.098, 0.034 }, { 0.05, 0.019 }, { 0, 0.016 },
  },
}
return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 128) },
  camera = camera.perspective { from = { 0, 0.42, 0.55 }, at = { 0, 0.045, 0 }, fov = 26 },
  lights = pile.lights(0.2, 1.1),
  objects = {
    pile.table_top(0.2, srgb("#8c9a8a")),
    object { shape = bowl, material = material.plastic { color = srgb("#3f6f8a"), roughness = 0.2 } },
    generator.fibres {
      target = mesh.lathe { profile = { { 0, 0 }, { 0.05, 0.007 }, { 0.09, 0.03 }, { 0.105, 0.055 }, { 0.09, 0.08 }, { 0.05, 0.103 }, { 0, 0.11 } } },
      position = { 0, 0.038, 0 }, container = bowl, floor = 0, gravity = true,
      count = arg("count", 200), length = 0.3, segments = 48, radius = mm(1.5), theta = { 2, 20 }, phi = { -20, 20 },
      seed = arg("seed", 1), material = material.plastic { color = srgb("#e8d29a"), roughness = 0.35 },
    },
  },
}
