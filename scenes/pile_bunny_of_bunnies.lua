-- A bunny of bunnies (Sakurai 2013, figure 4.10 e): small ones in pastel glazes pile up to a large one.
local pile = include("parts/pile.lua")
local bunny_file = arg("bunny", "/usr/share/glmark2/models/bunny.obj")

local glazes = pile.palette("#e8c9c4", "#c9dbe4", "#efe3c2", "#cfe0cb", "#dccbe2", "#f2ead9")

return scene {
  film = { width = 1280, height = 720, samples = 128, clamp = 4, depth = 10, exposure = -0.1 },
  camera = camera.perspective { from = { -0.14, 0.3, 0.62 }, at = { -0.005, 0.086, 0 }, fov = 22, aperture = 0.004, focus = 0.65 },
  lights = pile.lights(0.2, 0.9),
  objects = {
    pile.table_top(0.2, srgb("#7f909b")),
    generator.pile {
      target = mesh.file { path = bunny_file, size = 0.19 },
      components = {
        { shape = mesh.file { path = bunny_file, size = mm(13) }, material = material.plastic { palette = glazes, roughness = 0.25 } },
      },
      rotation = { 40, 360, 40 }, cover = arg("cover", 0.97), seed = arg("seed", 1),
    },
  },
}
