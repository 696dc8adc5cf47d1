-- Rice balls: grains all around a rounded triangle, a sheet of seaweed about the foot.
local pile = include("parts/pile.lua")

return scene {
  film = { width = 1280, height = 720, samples = 128, clamp = 4, depth = 12 },
  camera = camera.perspective { from = { -0.08, 0.15, 0.35 }, at = { 0.0, 0.042, 0 }, fov = 18, aperture = 0.004, focus = 0.37 },
  lights = pile.lights(0.12, 1.15),
  objects = {
    pile.table_top(0.12, srgb("#7d8f7c")),
    object {
      shape = mesh.box { width = mm(33), height = mm(31), depth = mm(51), rounding = 0.12 },
      material = material.plastic { color = srgb("#18241b"), roughness = 0.45 },
    },
    generator.pile {
      target = pile.rice_ball(0.085),
      components = { { shape = mesh.rice { length = mm(6.2), width = mm(2.5), bend = 9 }, material = pile.steamed_rice() } },
      spacing = 1, refine = 4, rotation = { 25, 360, 25 }, settle = 10, cover = arg("cover", 0.98), seed = arg("seed", 1),
    },
  },
}
