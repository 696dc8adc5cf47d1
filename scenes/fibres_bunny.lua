-- Staple fibres in the bunny (Sakurai 2013, figures 5.6 to 5.9): --set figure=5.6a to 5.6d, 5.8a, 5.8b, 5.9a, 5.9b.
-- With --set contact=true they do not overlap.
local pile = include("parts/pile.lua")
local bunny_file = arg("bunny", "/usr/share/glmark2/models/bunny.obj")

local figures = {
  ["5.6a"] = { theta = { 0, 0 }, phi = { 0, 0 } },
  ["5.6b"] = { theta = { 0, 10.8 }, phi = { 0, 0 } },
  ["5.6c"] = { theta = { -10.8, 10.8 }, phi = { 0, 0 } },
  ["5.6d"] = { theta = { 0, 10.8 }, phi = { 0, 36 } },
  ["5.8a"] = { theta = { 0, 10.8 }, phi = { 0, 36 }, length = 20 },
  ["5.8b"] = { theta = { 0, 10.8 }, phi = { 0, 36 }, length = 5 },
  ["5.9a"] = { theta = { 0, 10.8 }, phi = { 0, 36 }, count = 1024 },
  ["5.9b"] = { theta = { 0, 10.8 }, phi = { 0, 36 }, count = 512 },
}
local figure = figures[arg("figure", "5.6c")]

return scene {
  film = { width = 1280, height = 720, samples = 128 },
  camera = camera.perspective { from = { -0.14, 0.3, 0.62 }, at = { -0.005, 0.086, 0 }, fov = 22 },
  lights = pile.lights(0.2, 0.9),
  objects = {
    pile.table_top(0.2, srgb("#7f909b")),
    generator.fibres {
      target = mesh.file { path = bunny_file, size = 0.2 }, count = figure.count or 2048,
      length = (figure.length or 10) / 100, radius = mm(0.4), theta = figure.theta, phi = figure.phi,
      contact = arg("contact", false), adjustment = arg("adjustment", "nearest"), seed = arg("seed", 1),
      material = material.matte { color = srgb("#cfc6b8") },
    },
  },
}
