-- Three bunnies of three marbles in a hall, on a floor of two: no two tiles are the same piece.
local bunny_file = arg("bunny", "/usr/share/glmark2/models/bunny.obj")

local function stone(settings, roughness)
  return material.plastic { color = procedural.marble(settings), roughness = roughness or 0.12 }
end

local objects = {}
local function add(shape, material, x, y, z, turn)
  objects[#objects + 1] = object { shape = shape, material = material, position = { x, y, z }, rotation = { 0, turn or 0, 0 } }
end

-- The floor: tiles set at a slant, each cut from elsewhere.
local tile = 0.6
local light_tile = stone({ preset = "carrara", size = 0.9, vary = true, axis = { 1, 0.3, 0.4 } }, 0.07)
local dark_tile = stone({ preset = "nero_marquina", size = 0.8, vary = true, axis = { 1, 0.5, -0.3 } }, 0.07)
local slab = mesh.box { width = tile - 0.003, height = 0.03, depth = tile - 0.003, rounding = 0.06 }
for i = -7, 7 do
  for j = -22, 6 do
    add(slab, (i + j) % 2 == 0 and light_tile or dark_tile, i * tile, -0.03, j * tile, 90 * ((i * 7 + j * 3) % 4))
  end
end
add(mesh.plane { size = 60 }, material.matte { color = { 0.16, 0.15, 0.13 } }, 0, -0.012, 0) -- joints, and the ground outside

-- Columns along both sides; the left row is open to the garden.
local column_stone = stone({ preset = "carrara", size = 1.6, axis = { 0.5, 1, 0.3 }, vary = true }, 0.25)
local column = mesh.lathe {
  steps = 6, segments = 96,
  profile = {
    { 0.3, 0 }, { 0.3, 0 }, { 0.3, 0.1 }, { 0.3, 0.1 }, { 0.28, 0.12 }, { 0.31, 0.16 }, { 0.28, 0.21 }, { 0.235, 0.23 }, { 0.25, 0.27 },
    { 0.23, 0.31 }, { 0.215, 0.34 }, { 0.215, 0.34 }, { 0.21, 1.3 }, { 0.18, 3.2 }, { 0.18, 3.2 }, { 0.2, 3.23 }, { 0.18, 3.26 },
    { 0.18, 3.26 }, { 0.24, 3.38 }, { 0.29, 3.45 }, { 0.29, 3.45 }, { 0.29, 3.55 },
  },
}
for i = 0, 5 do
  for _, x in ipairs { -2.3, 2.3 } do
    add(column, column_stone, x, 0, 0.6 - 2.4 * i, 40 * i)
  end
end

local plaster = material.matte { color = srgb("#8c9a8f") }
local hall = 16
add(mesh.box { width = 0.5, height = 4.6, depth = hall, rounding = 0 }, plaster, 3.3, 0, -5.5)
add(mesh.box { width = 9, height = 4.6, depth = 0.5, rounding = 0 }, plaster, 0, 0, -13.2)
for _, x in ipairs { -2.3, 2.3 } do -- architraves
  add(mesh.box { width = 0.5, height = 0.55, depth = hall, rounding = 0 }, plaster, x, 3.55, -5.5)
end
add(mesh.box { width = 8, height = 0.2, depth = hall, rounding = 0 }, plaster, 0, 4.1, -5.5)

add(mesh.box { width = 3, height = 2.6, depth = 60, rounding = 0.5 }, material.matte { color = { 0.035, 0.075, 0.02 } }, -11, -0.2, -10) -- a hedge

-- Plinths and what stands on them.
local plinth = mesh.lathe {
  spline = false, segments = 96,
  profile = { { 0.36, 0 }, { 0.36, 0.07 }, { 0.31, 0.1 }, { 0.31, 0.56 }, { 0.35, 0.6 }, { 0.35, 0.66 } },
}
local bunnies = {
  { "rosso_levanto", -1.0, -0.1, 25 },
  { "calacatta", 0, 0.35, 0 },
  { "verde_alpi", 1.0, -0.1, -25 },
}
for i, b in ipairs(bunnies) do
  local preset, x, z, turn = table.unpack(b)
  add(plinth, stone({ preset = "emperador", size = 0.5, seed = i }, 0.15), x, 0, z)
  add(mesh.file { path = bunny_file, size = 0.62 }, stone({ preset = preset, size = 0.42, axis = { 0.4, 1, 0.3 }, seed = 3 + i }), x, 0.66, z, turn)
end

return scene {
  film = { width = 1280, height = 720, samples = 128, clamp = 3, depth = 10, exposure = -0.2 },
  camera = camera.perspective { from = { -0.2, 1.35, 4.3 }, at = { 0.0, 0.82, 0 }, fov = 26, aperture = 0.012, focus = 4.1 },
  lights = {
    light.sky { zenith = { 0.35, 0.55, 0.95 }, horizon = { 0.95, 0.97, 1.0 }, ground = { 0.35, 0.33, 0.3 }, strength = 0.9 },
    light.sun { direction = { -1.0, 0.62, 0.85 }, angle = 1.2, color = { 1.0, 0.87, 0.7 }, strength = 6 },
  },
  objects = objects,
}
