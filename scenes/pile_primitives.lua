-- Tori, balls and boxes piled up to a bunny (Sakurai 2013, figure 4.11 a).
local pile = include("parts/pile.lua")

local function glossy(...)
  return material.plastic { palette = pile.palette(...), roughness = 0.2 }
end

return scene {
  film = { width = 1280, height = 720, samples = 128, clamp = 4, depth = 10, exposure = -0.1 },
  camera = camera.perspective { from = { -0.14, 0.3, 0.62 }, at = { -0.005, 0.086, 0 }, fov = 22, aperture = 0.004, focus = 0.65 },
  lights = pile.lights(0.2, 0.9),
  objects = {
    pile.table_top(0.2, srgb("#b9b4aa")),
    generator.pile {
      target = mesh.file { path = arg("bunny", "/usr/share/glmark2/models/bunny.obj"), size = 0.19 },
      components = {
        { shape = mesh.torus { radius = mm(6), tube = mm(1.9) }, material = glossy("#c8452f", "#d4573c", "#b93c2b"), weight = 1 },
        { shape = mesh.sphere { radius = mm(3.2), segments = 48 }, material = glossy("#e9b949", "#f0c862", "#dda937"), weight = 2 },
        { shape = mesh.box { width = mm(4.6), rounding = 0.08 }, material = glossy("#2f7f86", "#3b9196", "#286f77"), weight = 3 },
      },
      rotation = { 360, 360, 360 }, cover = arg("cover", 0.98), seed = arg("seed", 1),
    },
  },
}
