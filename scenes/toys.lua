-- Toys on a playroom floor in the morning sun: twelve kinds of component, placed by fill_gap.
local seed = arg("seed", 7)

-- A palette of painted wood and plastic.
local red, orange, yellow = srgb("#d6392f"), srgb("#ef8a2c"), srgb("#f2c23a")
local green, teal, blue = srgb("#4f9a4a"), srgb("#2f9c98"), srgb("#2f66b0")
local violet, pink, cream = srgb("#7a539c"), srgb("#e58aa0"), srgb("#efe4cf")

local function colors(...)
  local list = {}
  for i, color in ipairs({ ... }) do list[i] = { color = color } end
  return list
end

local painted = material.plastic { palette = colors(red, yellow, green, blue), roughness = 0.35 }
local pastel = material.plastic { palette = colors(teal, pink, orange, cream), roughness = 0.25 }
local candy = material.plastic { palette = colors(violet, red, teal, yellow, pink), roughness = 0.15 }
local fur = material.matte { palette = colors(cream, srgb("#b98d63"), srgb("#8e8a86"), srgb("#e9cfc0")) }
local banana = material.plastic { color = srgb("#e9c02f"), roughness = 0.45 }
local brass = material.metal { preset = "brass", roughness = 0.25 }
local steel = material.metal { preset = "iron", roughness = 0.3 }
local glass = material.glass {}

local bunny = mesh.file { path = "/usr/share/glmark2/models/bunny.obj", size = 0.13 }

local toys = generator.layout {
  method = "fill_gap",
  domain = region.circle { radius = 1.25 },
  components = {
    { shape = bunny, material = fur, weight = 3 },
    { shape = mesh.banana {}, material = banana },
    { shape = mesh.l_brick {}, material = painted, weight = 2 },
    { shape = mesh.star {}, material = candy, weight = 2 },
    { shape = mesh.jack {}, material = brass },
    { shape = mesh.gear {}, material = pastel },
    { shape = mesh.torus {}, material = candy, weight = 2 },
    { shape = mesh.letter { letter = "S" }, material = painted },
    { shape = mesh.letter { letter = "R" }, material = painted },
    { shape = mesh.sphere { radius = 0.03 }, material = pastel, weight = 2 },
    { shape = mesh.block {}, material = painted, weight = 2 },
    { shape = mesh.tree {}, material = pastel },
  },
  rotation = { 0, 360 },
  scale = { 0.85, 1.15 },
  seed = seed,
}

return scene {
  film = { width = 1280, height = 720, samples = 128 },
  camera = camera.perspective { from = { 0.1, 0.95, 1.5 }, at = { 0, 0.0, 0.12 }, fov = 34, aperture = 0.012 },
  lights = {
    light.sky { zenith = { 0.35, 0.5, 0.8 }, horizon = { 0.9, 0.95, 1.0 }, ground = { 0.3, 0.28, 0.25 }, strength = 0.55 },
    light.sun { direction = { -1.2, 0.9, -0.5 }, angle = 2, color = { 1.0, 0.88, 0.7 }, strength = 4 },
  },
  objects = {
    toys,
    object { shape = mesh.plane { size = 12 }, material = material.matte { color = srgb("#b08a63") } },
  },
}
