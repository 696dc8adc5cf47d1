-- Staple fibres in the bunny (Sakurai 2013, figures 5.6, 5.8 and 5.9): --set figure=5.6a to 5.6d, 5.8a, 5.8b, 5.9a,
-- 5.9b; with --set target=FILE in another shape (figure 5.7 has a dragon: 5.7a to 5.7d). With --set contact=true
-- they do not overlap.
local pile = include("parts/pile.lua")
local fibres = include("parts/fibres.lua")
local figure = include("parts/fibre_figures.lua")(arg("figure", "5.6c"))

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 128) },
  camera = camera.perspective { from = { -0.2, 0.29, 0.6 }, at = { -0.002, 0.092, 0 }, fov = 20.5 },
  lights = fibres.lights(0.2, 1.1),
  objects = {
    pile.table_top(0.2, srgb("#4d5c68")),
    generator.fibres {
      target = mesh.file { path = arg("target", "/usr/share/glmark2/models/bunny.obj"), size = 0.2 }, count = figure.count,
      length = figure.length / 100, segments = figure.segments, radius = mm(0.4), theta = figure.theta, phi = figure.phi,
      contact = arg("contact", false), adjustment = arg("adjustment", "nearest"), seed = arg("seed", 1),
      material = material.matte { color = srgb("#cfc6b8") },
    },
  },
}
