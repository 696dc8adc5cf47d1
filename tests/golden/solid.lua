-- Solid textures on what they are cut to: veins, rings, grains and cracks.
local function piece(x, z, shape, color, roughness)
  return object { shape = shape, material = material.plastic { color = color, roughness = roughness }, position = { x, 0, z }, rotation = { 0, 30, 0 } }
end
local ball = mesh.cut_sphere { radius = 0.06, segments = 64 }
local block = mesh.box { width = 0.09, rounding = 0.05 }

return scene {
  film = { width = 160, height = 90, samples = 64, clamp = 4 },
  camera = camera.perspective { from = { 0, 0.3, 0.6 }, at = { 0, 0.045, 0.02 }, fov = 32 },
  lights = { light.sky { strength = 0.6 }, light.sun { direction = { -1, 1.6, 1 }, angle = 4 } },
  objects = {
    piece(-0.21, 0, ball, procedural.marble { preset = "carrara", size = 0.1 }, 0.2),
    piece(-0.07, 0, ball, procedural.wood { size = 0.12 }, 0.4),
    piece(0.07, 0, block, procedural.granite { size = 0.1 }, 0.3),
    piece(0.2, 0, block, procedural.breccia { size = 0.1 }, 0.3),
    piece(-0.05, 0.14, mesh.box { width = 0.05, rounding = 0.05 }, procedural.stone { size = 0.1 }, 0.5),
    piece(0.08, 0.14, mesh.box { width = 0.05, rounding = 0.05 }, procedural.bark { size = 0.1 }, 0.6),
    object { shape = mesh.plane { size = 4 }, material = material.matte { color = procedural.checker { size = 0.1 } } },
  },
}
