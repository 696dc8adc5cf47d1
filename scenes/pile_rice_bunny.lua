-- A bunny of steamed rice on a dark tray (Sakurai 2013, figure 4.10 a): grains piled on the
-- bunny's surface, of which nothing else is shown.
local bunny_file = arg("bunny", "/usr/share/glmark2/models/bunny.obj")

local pile = include("parts/pile.lua")

-- Steamed grains are short and plump.
local grain = mesh.rice { length = mm(6.2), width = mm(2.5), bend = 9 }

local bunny = generator.pile {
  target = mesh.file { path = bunny_file, size = mm(150) },
  components = { { shape = grain, material = pile.steamed_rice() } },
  spacing = 1, refine = arg("refine", 11), rotation = { 20, 360, 20 },
  settle = arg("settle", 10), cover = arg("cover", 0.99), seed = arg("seed", 1),
}

local table_top = material.plastic { color = srgb("#5a4030"), roughness = 0.25 }
local dish = mesh.cylinder { radius = mm(98), height = mm(5), segments = 128 }

return scene {
  film = { width = 1280, height = 720, samples = 128, clamp = 4, depth = 12, exposure = 0.4 },
  camera = camera.perspective { from = { 0.12, 0.235, 0.4 }, at = { 0.002, 0.068, 0 }, fov = 25, aperture = 0.004, focus = 0.4 },
  lights = {
    light.sky { zenith = { 0.75, 0.85, 1.0 }, horizon = { 1.0, 0.97, 0.93 }, ground = { 0.25, 0.2, 0.17 }, strength = 0.42 },
    light.sun { direction = { -1.0, 0.85, 0.3 }, angle = 7, color = { 1.0, 0.93, 0.82 }, strength = 3 },
  },
  objects = {
    object { shape = mesh.plane { size = 4 }, material = table_top, position = { 0, mm(-9), 0 } },
    object { shape = dish, material = material.plastic { color = srgb("#1d2a38"), roughness = 0.15 }, position = { 0, mm(-9), 0 } },
    bunny,
  },
}
