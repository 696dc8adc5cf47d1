-- Four kinds of nests (Sakurai 2013, figure 5.11): straight twigs, bent to both sides, bent evenly, bent at random.
local pile = include("parts/pile.lua")
local nest = include("parts/nest.lua")
local figures = include("parts/fibre_figures.lua")

local objects = { pile.table_top(0.2, srgb("#8d9178")) }
for i, name in ipairs { "5.11b", "5.11c", "5.11d", "5.11e" } do
  local figure = figures(name)
  objects[#objects + 1] = generator.fibres {
    name = name, target = nest.shape, position = { ((i - 1) % 2 - 0.5) * 0.24, 0.001, (i > 2 and 0.13 or -0.13) },
    count = arg("count", figure.count), length = 0.07, segments = figure.segments, radius = mm(0.55), taper = 0.6,
    theta = figure.theta, phi = figure.phi, contact = arg("contact", true), seed = i,
    material = nest.twigs,
  }
end

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 128) },
  camera = camera.perspective { from = { 0, 0.5, 0.56 }, at = { 0, 0.01, 0.012 }, fov = 35 },
  lights = pile.lights(0.2, 1.0),
  objects = objects,
}
