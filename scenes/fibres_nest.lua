-- A bird's nest: twigs that run around a hollow and do not pass through each other.
local pile = include("parts/pile.lua")

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 128) },
  camera = camera.perspective { from = { 0, 0.26, 0.42 }, at = { 0, 0.028, 0 }, fov = 25 },
  lights = pile.lights(0.2, 1.0),
  objects = {
    pile.table_top(0.2, srgb("#8d9178")),
    generator.fibres {
      target = mesh.lathe { profile = {
        { 0, 0 }, { 0.05, 0.002 }, { 0.088, 0.022 }, { 0.1, 0.05 }, { 0.09, 0.062 }, { 0.072, 0.058 }, { 0.055, 0.034 }, { 0.03, 0.022 }, { 0, 0.019 },
      } },
      count = arg("count", 900), length = { 0.08, 0.17 }, segments = 24, radius = mm(0.8), taper = 0.6, theta = { -5, 6 }, phi = { -20, 20 },
      flow = field.whirl { turn = 90 }, flow_strength = 0.25, seed = arg("seed", 1),
      material = material.plastic { palette = pile.palette("#6b4f35", "#8a6a45", "#4f3a28", "#9a7c55", "#5d4a3a"), roughness = 0.6 },
    },
    object { shape = mesh.sphere { radius = 0.016 }, scale = { 0.8, 0.8, 1.05 }, position = { -0.014, 0.036, 0.004 }, material = material.plastic { color = srgb("#a9c4c4"), roughness = 0.35 } },
    object { shape = mesh.sphere { radius = 0.016 }, scale = { 0.8, 0.8, 1.05 }, rotation = { 0, 60, 0 }, position = { 0.016, 0.036, -0.006 }, material = material.plastic { color = srgb("#9dbcbd"), roughness = 0.35 } },
  },
}
