-- A ball of wool: curled fibres that touch and do not overlap (Sakurai 2013, figure 5.12: --set figure=5.12b to 5.12e).
local pile = include("parts/pile.lua")
local fibres = include("parts/fibres.lua")
local figure = include("parts/fibre_figures.lua")(arg("figure", "5.12b"))

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 128) },
  camera = camera.perspective { from = { -0.02, 0.19, 0.38 }, at = { 0.008, 0.046, 0 }, fov = 19 },
  lights = fibres.lights(0.12, 1.1),
  objects = {
    pile.table_top(0.2, srgb("#4c5b52")),
    generator.fibres {
      target = mesh.sphere { radius = 0.05 }, count = arg("count", figure.count), length = arg("length", 0.1), segments = figure.segments,
      radius = mm(0.22), theta = figure.theta, phi = figure.phi, seed = arg("seed", 1),
      material = material.fibre { preset = "wool", color = srgb("#d9c7a8") },
    },
  },
}
