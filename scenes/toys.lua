-- Toys on the boards of a playroom, the morning sun low through two windows: thirteen kinds of
-- component, placed by fill_gap so that no two outlines overlap, ever farther apart towards the wall.
local seed = arg("seed", 4)

-- The toys: a few colours that go together, all of one warmth.
local red, orange, yellow = srgb("#c9412f"), srgb("#df8038"), srgb("#e9b440")
local green, teal, blue = srgb("#6f9a5b"), srgb("#2f8f8c"), srgb("#2c5f94")
local pink, cream = srgb("#e3a094"), srgb("#e6d8bf")

local painted = material.plastic { palette = { red, yellow, teal, blue, orange }, roughness = 0.4 }
local pastel = material.plastic { palette = { teal, pink, orange, cream }, roughness = 0.3 }
local candy = material.plastic { palette = { red, blue, teal, yellow, pink }, roughness = 0.25 }
local plush = material.matte { palette = { cream, srgb("#b98d63"), srgb("#8f8781"), srgb("#e2c4b2") } }
local peel = material.plastic { color = srgb("#e6bd2c"), roughness = 0.5 }
local duck = material.plastic { color = srgb("#f0b91e"), roughness = 0.25 }
local leaves = material.plastic { palette = { green, srgb("#8bab55"), srgb("#4f8560") }, roughness = 0.4 }
local brass = material.metal { preset = "brass", roughness = 0.35 }

local bunny = mesh.file { path = "/usr/share/glmark2/models/bunny.obj", size = 0.17 }
local margin = 0.012

local toys = generator.layout {
  name = "toys",
  method = "fill_gap",
  -- From all of the front to a narrow end by the wall, round the tower that stands there.
  domain = region.polygon {
    points = {
      { -0.95, 1.3 }, { 1.15, 1.3 }, { 1.3, 0.6 }, { 1.25, 0.1 }, { 1.0, -0.4 }, { 0.95, -0.9 }, { 0.6, -1.25 },
      { -0.1, -1.25 }, { -0.5, -0.9 }, { -0.75, -0.4 }, { -1.15, 0.0 }, { -1.3, 0.6 },
    },
    holes = { { points = { { 0.12, -0.5 }, { 0.62, -0.5 }, { 0.62, -1.0 }, { 0.12, -1.0 } } } },
  },
  density = field["function"] {
    value = function(x, z) return 0.1 + 5 * math.max(0, (0.7 - z) / 1.9) ^ 2 end, width = 3, depth = 3,
  },
  components = {
    { shape = bunny, material = plush, weight = 3.5, margin = margin },
    { shape = mesh.banana { length = 0.2 }, material = peel, margin = margin, weight = 0.7 },
    { shape = mesh.l_brick { length = 0.11 }, material = painted, weight = 2, margin = margin },
    { shape = mesh.star { radius = 0.065 }, material = candy, weight = 2, margin = margin },
    { shape = mesh.gear { radius = 0.06 }, material = pastel, margin = margin },
    { shape = mesh.ring { radius = 0.07 }, material = candy, weight = 2, margin = margin },
    { shape = mesh.letter { letter = "S", size = 0.11 }, material = painted, margin = margin },
    { shape = mesh.letter { letter = "R", size = 0.11 }, material = painted, margin = margin },
    { shape = mesh.sphere { radius = 0.045 }, material = pastel, margin = margin },
    { shape = mesh.block { size = 0.085 }, material = painted, weight = 2, margin = margin },
    { shape = mesh.duck { length = 0.13 }, material = duck, margin = margin },
    { shape = mesh.tree { height = 0.17 }, material = leaves, weight = 0.7, margin = margin },
    { shape = mesh.jack { size = 0.075 }, material = brass, weight = 0.6, margin = margin },
  },
  rotation = { 0, 360 },
  scale = { 0.85, 1.15 },
  cancellations = 600,
  seed = seed,
}

local objects = { toys }
local function add(shape, look, position, rotation)
  objects[#objects + 1] = object { shape = shape, material = look, position = position, rotation = rotation }
end

-- A tower of blocks, towards which the toys lead.
local function paint(color) return material.plastic { color = color, roughness = 0.4 } end
local block = mesh.block { size = 0.1 }
add(block, paint(blue), { 0.3, 0, -0.77 }, { 0, 12, 0 })
add(block, paint(yellow), { 0.41, 0, -0.76 }, { 0, -8, 0 })
add(block, paint(red), { 0.352, 0.1, -0.765 }, { 0, 24, 0 })
add(mesh.cylinder { radius = 0.042, height = 0.09, rounding = 0.1 }, paint(cream), { 0.35, 0.2, -0.765 })
add(mesh.cone { radius = 0.06, height = 0.09 }, paint(teal), { 0.35, 0.29, -0.765 })

-- The floor: oak boards that run towards the wall, sawn from different places of their trees.
local shades = { { "#c69c6a", "#a07544" }, { "#bb8f5e", "#94693d" }, { "#cfa877", "#a97f4e" }, { "#c09462", "#8f6438" } }
local boards = {}
for i = 0, 11 do
  local shade = shades[i % #shades + 1]
  boards[i] = material.plastic {
    color = procedural.wood {
      preset = "oak", early = srgb(shade[1]), late = srgb(shade[2]), axis = { 0, 0, 1 },
      origin = { 0.05 * (i % 5 - 2), -0.05 - 0.03 * (i % 4), 0 }, vary = true,
    },
    roughness = 0.38,
  }
end
local width, length, thickness = 0.135, 1.6, 0.02
local board = mesh.box { width = width - 0.0024, height = thickness, depth = length - 0.0024, rounding = 0.12 }
for column = -19, 19 do
  local shift = (column * 0.618) % 1
  for row = -1, 2 do
    add(board, boards[(column * 7 + row * 5) % 12], { column * width, -thickness, -1.5 + (row + shift) * length })
  end
end
add(mesh.plane { size = 12 }, material.matte { color = 0.02 }, { 0, -thickness, 0 })

-- The far wall with its skirting.
local white = material.plastic { color = srgb("#e9e4d8"), roughness = 0.4 }
add(mesh.box { width = 8, height = 3, depth = 0.1, rounding = 0 }, material.matte { color = srgb("#b7c4bb") }, { 0, -0.1, -1.65 })
add(mesh.box { width = 8, height = 0.12, depth = 0.018, rounding = 0.2 }, white, { 0, 0, -1.591 })
add(mesh.box { width = 8, height = 0.022, depth = 0.03, rounding = 0.6 }, white, { 0, 0, -1.585 })

-- The wall to the left, out of the picture: two windows of fifteen panes cut the sunlight.
local x, sill, top = -2.4, 0.42, 1.85
local plaster = material.matte { color = srgb("#d8d4c8") }
local function wall(from, to, bottom, height) -- along z
  add(mesh.box { width = 0.16, height = height, depth = to - from, rounding = 0 }, plaster, { x - 0.08, bottom, (from + to) / 2 })
end
wall(-1.7, 4, 0, sill)
wall(-1.7, 4, top, 3 - top)
local windows = { { -1.4, 0.3 }, { 0.5, 2.2 } }
wall(-1.7, windows[1][1], sill, top - sill)
wall(windows[1][2], windows[2][1], sill, top - sill)
wall(windows[2][2], 4, sill, top - sill)
for _, window in ipairs(windows) do
  local middle, span, height = (window[1] + window[2]) / 2, window[2] - window[1], top - sill
  for i = 0, 5 do -- uprights
    add(mesh.box { width = 0.04, height = height, depth = 0.04, rounding = 0 }, white, { x, sill, window[1] + i * span / 5 })
  end
  for i = 0, 3 do -- bars
    add(mesh.box { width = 0.04, height = 0.04, depth = span, rounding = 0 }, white, { x, sill - 0.02 + i * height / 3, middle })
  end
end

return scene {
  film = { width = 1280, height = 720, samples = 48, clamp = 6, exposure = 0.2 },
  camera = camera.perspective {
    from = { 0.12, 0.66, 1.85 }, at = { 0.08, 0.06, 0.05 }, fov = 36, aperture = 0.012, focus = 1.8,
  },
  lights = {
    light.sky { zenith = { 0.5, 0.62, 0.85 }, horizon = { 0.9, 0.95, 1.0 }, ground = { 0.5, 0.42, 0.34 }, strength = 0.4 },
    light.sun { direction = { -1, 0.52, 0.3 }, angle = 1, color = { 1.0, 0.84, 0.64 }, strength = 8 },
    light.area { position = { -1.7, 1.6, 2.6 }, at = { 0, 0.1, 0 }, size = { 1.2, 1.2 }, color = { 0.85, 0.93, 1.0 }, strength = 2.5 },
  },
  objects = objects,
}
