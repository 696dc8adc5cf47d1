-- Single staple fibres: theta turns each segment about z, phi twists it, both at random in their
-- ranges (Table 5.1 of the thesis).
local strands = include("parts/strands.lua")
math.randomseed(arg("seed", 5))

local fibres = {
  -- theta, phi [deg]
  { { 0, 0 }, { 0, 0 } }, { { 3.6, 3.6 }, { 0, 0 } }, { { 7.2, 7.2 }, { 0, 0 } },
  { { 3.6, 3.6 }, { 3.6, 3.6 } }, { { 3.6, 3.6 }, { 7.2, 7.2 } }, { { 3.6, 3.6 }, { 10.8, 10.8 } },
  { { -3.6, 3.6 }, { 0, 0 } }, { { -7.2, 7.2 }, { 0, 0 } }, { { -3.6, 7.2 }, { 0, 0 } },
  { { -3.6, 18 }, { 21, 39.6 } },
}

local objects = {
  object { shape = mesh.plane { size = 40 }, rotation = { 90, 0, 0 }, position = { 0, 0, -0.5 }, material = material.matte { color = 0.8 } },
}
local colors = { srgb("#b5523b"), srgb("#2f6f8f"), srgb("#6b7f3a"), srgb("#8a5a8f"), srgb("#c08a2e") }
for i, fibre in ipairs(fibres) do
  local column, row = (i - 1) % 5, (i - 1) // 5
  local at = { (column - 2) * 0.95, 0.68 - row * 1.4, 0 }
  objects[#objects + 1] = object {
    shape = curve.polyline { points = strands.staple_fibre(1, 32, fibre[1], fibre[2]), radius = 0.012 },
    material = material.plastic { color = colors[column + 1], roughness = 0.4 },
    position = at, name = string.char(96 + i),
  }
  objects[#objects + 1] = object {
    shape = mesh.letter { letter = string.char(64 + i), size = 0.09 }, rotation = { 90, 0, 0 },
    material = material.matte { color = 0.05 }, position = { at[1], at[2] - 0.65, -0.1 },
  }
end

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 64) },
  camera = camera.perspective { from = { 0, 0, 9 }, at = { 0, 0, 0 }, fov = 18.5 },
  lights = { light.sky { strength = 0.6 }, light.sun { direction = { -0.6, 0.8, 1 }, angle = 3, strength = 1.6 } },
  objects = objects,
}
