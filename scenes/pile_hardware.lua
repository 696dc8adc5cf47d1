-- Gears, and bolts with nuts, piled up to a bunny and a wave (Sakurai 2013, figure 4.16).
local pile = include("parts/pile.lua")
local bunny = "/usr/share/glmark2/models/bunny.obj"

local brass = material.metal { preset = "brass", roughness = 0.28 }
local steel = material.metal { palette = { { 0.60, 0.59, 0.57 }, { 0.54, 0.54, 0.54 }, { 0.66, 0.63, 0.58 } }, roughness = 0.3 }
local black = material.metal { palette = { { 0.16, 0.16, 0.17 }, { 0.22, 0.21, 0.21 } }, roughness = 0.4 }

local gears = {
  { shape = mesh.gear { radius = mm(6.5), teeth = 14 }, material = brass },
  { shape = mesh.gear { radius = mm(4.2), teeth = 11, holes = 0 }, material = steel },
}
local fasteners = {
  { shape = mesh.bolt { diameter = mm(2), length = mm(7) }, material = steel },
  { shape = mesh.nut { diameter = mm(2.7), thread = false }, material = black },
}

local function heap(target, components, rotation, refine, x, z)
  return generator.pile {
    target = target, components = components, rotation = rotation, refine = refine,
    position = { x, 0, z }, cover = arg("cover", 0.95), seed = arg("seed", 1),
  }
end

return scene {
  film = { width = 1280, height = 720, samples = 144, clamp = 2, depth = 10, exposure = 0.2 },
  camera = camera.perspective { from = { 0.02, 0.33, 0.72 }, at = { 0.004, 0.06, 0 }, fov = 20, aperture = 0.004, focus = 0.76 },
  lights = pile.lights(0.2, 1),
  objects = {
    pile.table_top(0.2, srgb("#8d979e")),
    heap(mesh.file { path = bunny, size = 0.16 }, gears, { 70, 360, 70 }, 2, -0.115, 0),
    heap(pile.wave(0.21), fasteners, { 180, 360, 90 }, 1, 0.1, 0.02),
  },
}
