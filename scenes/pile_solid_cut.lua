-- A rice ball cut open (Sakurai 2013, figure 4.15): its inside is filled with grains too.
local pile = include("parts/pile.lua")

return scene {
  film = { width = 1280, height = 720, samples = 128, clamp = 4, depth = 12 },
  camera = camera.perspective { from = { 0.1, 0.14, 0.3 }, at = { 0.0, 0.042, 0 }, fov = 20 },
  lights = pile.lights(0.12, 1.15),
  objects = {
    pile.table_top(0.12, srgb("#7d8f7c")),
    generator.pile {
      target = pile.rice_ball(0.085), fill = "solid",
      spacing = 1.5,
      components = { { shape = mesh.rice { length = mm(6.2), width = mm(2.5), bend = 9 }, material = pile.steamed_rice() } },
      rotation = { 360, 360, 360 }, cover = 0, seed = arg("seed", 1),
      cut = { normal = { 0, 0, 1 }, point = { 0, 0, 0 } },
    },
  },
}
