-- Toys on a playroom rug in the morning sun: twelve kinds of component, placed by fill_gap so that
-- no two outlines overlap.
local seed = arg("seed", 7)

local red, orange, yellow = srgb("#cf3a2e"), srgb("#e8842a"), srgb("#eebb35")
local green, teal, blue = srgb("#4f9a4a"), srgb("#2f9c98"), srgb("#2f62a8")
local violet, pink, cream = srgb("#75509a"), srgb("#e58aa0"), srgb("#ece0ca")

local painted = material.plastic { palette = { red, yellow, green, blue }, roughness = 0.4 }
local pastel = material.plastic { palette = { teal, pink, orange, cream }, roughness = 0.3 }
local candy = material.plastic { palette = { violet, red, teal, yellow }, roughness = 0.25 }
local plush = material.matte { palette = { cream, srgb("#b98d63"), srgb("#8e8a86"), srgb("#e5c7b5") } }
local peel = material.plastic { color = srgb("#e6bd2c"), roughness = 0.5 }
local duck = material.plastic { color = srgb("#f0b91e"), roughness = 0.25 }
local leaves = material.plastic { palette = { green, teal, srgb("#8bb04a") }, roughness = 0.4 }
local brass = material.metal { preset = "brass", roughness = 0.35 }

local bunny = mesh.file { path = "/usr/share/glmark2/models/bunny.obj", size = 0.17 }

local toys = generator.layout {
  method = "fill_gap",
  domain = region.circle { radius = 1.15, segments = 96 },
  components = {
    { shape = bunny, material = plush, weight = 3 },
    { shape = mesh.banana { length = 0.2 }, material = peel },
    { shape = mesh.l_brick { length = 0.11 }, material = painted, weight = 2 },
    { shape = mesh.star { radius = 0.065 }, material = candy, weight = 2 },
    { shape = mesh.gear { radius = 0.06 }, material = pastel },
    { shape = mesh.ring { radius = 0.07 }, material = candy, weight = 2 },
    { shape = mesh.letter { letter = "S", size = 0.11 }, material = painted },
    { shape = mesh.letter { letter = "R", size = 0.11 }, material = painted },
    { shape = mesh.sphere { radius = 0.045 }, material = pastel },
    { shape = mesh.block { size = 0.085 }, material = painted, weight = 2 },
    { shape = mesh.duck { length = 0.13 }, material = duck },
    { shape = mesh.tree { height = 0.17 }, material = leaves },
    { shape = mesh.jack { size = 0.075 }, material = brass, weight = 0.7 },
  },
  rotation = { 0, 360 },
  scale = { 0.85, 1.15 },
  seed = seed,
}

return scene {
  film = { width = 1280, height = 720, samples = 48, clamp = 8 },
  camera = camera.perspective {
    from = { 0.15, 1.12, 1.9 }, at = { 0, 0.0, 0.06 }, fov = 36, aperture = 0.015,
  },
  lights = {
    light.sky { zenith = { 0.35, 0.5, 0.8 }, horizon = { 0.9, 0.95, 1.0 }, ground = { 0.3, 0.28, 0.25 }, strength = 0.55 },
    light.sun { direction = { -1.2, 1.0, -0.3 }, angle = 2, color = { 1.0, 0.9, 0.76 }, strength = 4 },
  },
  objects = {
    toys,
    object { -- the rug
      shape = mesh.cylinder { radius = 1.3, height = 0.012, segments = 256 }, position = { 0, -0.012, 0 },
      material = material.matte { color = srgb("#8fa0a8") },
    },
    object { shape = mesh.plane { size = 14 }, position = { 0, -0.012, 0 }, material = material.matte { color = srgb("#9c7350") } },
  },
}
