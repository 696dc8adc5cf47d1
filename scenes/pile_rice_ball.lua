-- Rice balls: grains all around a rounded triangle, a sheet of seaweed about the foot.
local pile = include("parts/pile.lua")

return scene {
  film = { width = 1280, height = 720, samples = 128, clamp = 4, depth = 12 },
  camera = camera.perspective { from = { -0.06, 0.15, 0.36 }, at = { 0.0, 0.043, 0 }, fov = 21, aperture = 0.004, focus = 0.39 },
  lights = pile.lights(0.12, 0.9),
  objects = {
    pile.table_top(0.12, srgb("#2f3b33")),
    generator.pile {
      target = pile.rice_ball(0.085),
      components = { { shape = mesh.rice { length = mm(6.2), width = mm(2.5), bend = 9 }, material = pile.steamed_rice() } },
      rotation = { 50, 360, 50 }, cover = arg("cover", 0.98), seed = arg("seed", 1),
    },
  },
}
