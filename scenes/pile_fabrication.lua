-- A bunny of bananas for the printer (Sakurai 2013, figures 4.17 and 4.18): they reach into each
-- other by 0.35 of their largest inner ball, which holds them together.
--   scree bake scenes/pile_fabrication.lua -o bananas.stl
local pile = include("parts/pile.lua")

return scene {
  film = { width = 1280, height = 720, samples = 96, clamp = 4 },
  camera = camera.perspective { from = { -0.1, 0.2, 0.42 }, at = { -0.004, 0.052, 0 }, fov = 18 },
  lights = pile.lights(0.12, 1.25),
  objects = {
    pile.table_top(0.12, srgb("#9aa4ab")),
    generator.pile {
      target = mesh.file { path = arg("bunny", "/usr/share/glmark2/models/bunny.obj"), size = 0.11 },
      components = { { shape = mesh.banana { length = mm(arg("length", 12)) }, material = material.plastic { color = srgb("#e07a2c"), roughness = 0.5 } } },
      rotation = arg("random", false) and { 360, 360, 360 } or { 0, 360, 0 },
      overlap = 0.35, spacing = 2, refine = 2, cover = arg("cover", 0.9), seed = arg("seed", 1),
    },
  },
}
