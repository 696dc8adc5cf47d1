-- Fibres scattered on a table, where they fell (Sakurai 2013, figure 5.10).
local pile = include("parts/pile.lua")
local figure = include("parts/fibre_figures.lua")("5.10")

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 128) },
  camera = camera.perspective { from = { 0, 0.3, 0.42 }, at = { 0, 0, 0.01 }, fov = 26 },
  lights = pile.lights(0.2, 1.0),
  objects = {
    pile.table_top(0.2, srgb("#35302c")),
    generator.fibres {
      target = mesh.lathe { profile = { { 0, 0 }, { 0.17, 0 }, { 0.17, 0 }, { 0.13, 0.004 }, { 0.07, 0.012 }, { 0, 0.02 } } },
      count = arg("count", figure.count), length = { 0.02, 0.05 }, segments = figure.segments, radius = mm(0.16),
      theta = figure.theta, phi = figure.phi, gravity = true, floor = 0, stiffness = 0.7, seed = arg("seed", 1),
      material = material.fibre { preset = "cotton", color = srgb("#c9c4bc") },
    },
  },
}
