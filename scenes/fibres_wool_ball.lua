-- A ball of wool as in Sakurai 2013, figure 5.12: curled fibres that touch and do not overlap.
local pile = include("parts/pile.lua")

return scene {
  film = { width = 1280, height = 720, samples = 128 },
  camera = camera.perspective { from = { 0, 0.13, 0.4 }, at = { 0, 0.05, 0 }, fov = 22 },
  lights = pile.lights(0.2, 1.1),
  objects = {
    pile.table_top(0.2, srgb("#8c9a8a")),
    generator.fibres {
      target = mesh.sphere { radius = 0.05 }, count = arg("count", 2048), length = 0.06, radius = mm(0.22),
      theta = { 7.2, 14.4 }, phi = { 7.2, 14.4 }, seed = arg("seed", 1),
      material = material.fibre { preset = "wool", color = srgb("#d9c7a8") },
    },
  },
}
