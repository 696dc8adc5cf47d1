-- Felt: short wool in a sheet, pressed flat.
local pile = include("parts/pile.lua")

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 128) },
  camera = camera.perspective { from = { 0.012, 0.035, 0.05 }, at = { 0.004, 0.0, 0.002 }, fov = 30 },
  lights = pile.lights(0.03, 1.0),
  objects = {
    pile.table_top(0.03, srgb("#c9c2b4")),
    generator.fibres {
      target = mesh.box { width = 0.05, height = 0.0022, depth = 0.04, rounding = 0.9 }, position = { 0, 0.0012, 0 },
      count = arg("count", 6000), length = { 0.006, 0.012 }, segments = 16, radius = mm(0.036), theta = { -9, 12 }, phi = { -60, 60 },
      seed = arg("seed", 1), material = material.fibre { preset = "wool", color = srgb("#7d2f3a") },
    },
  },
}
