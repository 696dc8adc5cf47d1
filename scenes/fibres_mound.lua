-- A mound of the shape of a Gaussian (Sakurai 2013, figure 5.13: --set figure=5.13b to 5.13e).
local pile = include("parts/pile.lua")
local fibres = include("parts/fibres.lua")
local figure = include("parts/fibre_figures.lua")(arg("figure", "5.13b"))

local profile = { { 0, 0 }, { 0.12, 0 }, { 0.12, 0 } }
for i = 11, 0, -1 do
  local r = i * 0.01
  profile[#profile + 1] = { r, 0.003 + 0.06 * math.exp(-0.5 * (r / 0.04) ^ 2) }
end

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 128) },
  camera = camera.perspective { from = { 0, 0.16, 0.42 }, at = { 0, 0.022, 0 }, fov = 22 },
  lights = fibres.lights(0.2, 1.1),
  objects = {
    pile.table_top(0.2, srgb("#39434b")),
    generator.fibres {
      target = mesh.lathe { profile = profile }, count = arg("count", figure.count), length = 0.08, segments = figure.segments,
      radius = mm(0.22), theta = figure.theta, phi = figure.phi, seed = arg("seed", 1),
      material = material.fibre { preset = "wool", color = srgb("#b9a58c") },
    },
  },
}
