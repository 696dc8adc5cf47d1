-- Felt: short wool in a sheet, pressed flat.
local pile = include("parts/pile.lua")
local fibres = include("parts/fibres.lua")

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 128) },
  camera = camera.perspective { from = { 0.012, 0.04, 0.056 }, at = { 0.002, 0.0, 0.002 }, fov = 34 },
  lights = fibres.lights(0.04, 1.0),
  objects = {
    pile.table_top(0.03, srgb("#6f675c")),
    generator.fibres {
      target = mesh.box { width = 0.05, height = 0.0022, depth = 0.04, rounding = 0.9 }, position = { 0, 0.0001, 0 },
      count = arg("count", 6000), length = { 0.006, 0.012 }, segments = 16, radius = mm(0.036), theta = { -9, 12 }, phi = { -60, 60 },
      seed = arg("seed", 1), material = material.fibre { preset = "wool", color = srgb("#7d2f3a") },
    },
  },
}
