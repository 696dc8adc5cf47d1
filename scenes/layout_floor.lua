-- Sweets of seven kinds in the shape of a heart, saturated: a certificate says that none of them
-- fits anywhere any more, in any turn.
local heart = "M 0 0.92 C -0.18 0.66 -1 0.3 -1 -0.3 C -1 -0.68 -0.74 -0.9 -0.47 -0.9 C -0.24 -0.9 -0.08 -0.76 0 -0.58 "
  .. "C 0.08 -0.76 0.24 -0.9 0.47 -0.9 C 0.74 -0.9 1 -0.68 1 -0.3 C 1 0.3 0.18 0.66 0 0.92 Z"

local function sugar(...)
  local palette = {}
  for i, color in ipairs { ... } do
    palette[i] = srgb(color)
  end
  return material.plastic { palette = palette, roughness = 0.2 }
end

local berry, rose, cream, mint = "#c22745", "#ea7f97", "#f4e6d2", "#8fcbb0"
local lemon, lilac, orange, cocoa = "#f0cc52", "#a284c4", "#ee8b3a", "#6b3f2a"

local sweets = generator.layout {
  method = arg("method", "saturated"),
  domain = region.path { d = heart, size = 0.4 },
  components = {
    { shape = mesh.heart { width = 0.034, height = 0.012 }, material = sugar(berry, rose) },
    { shape = mesh.ring { radius = 0.0145, height = 0.0095 }, material = sugar(mint, lemon, rose) },
    { shape = mesh.star { radius = 0.016, height = 0.009 }, material = sugar(lemon, orange) },
    { shape = mesh.crescent { radius = 0.0165, waist = 0.7, height = 0.01 }, material = sugar(cream, lilac) },
    { shape = mesh.sphere { radius = 0.0105 }, material = sugar(cocoa, berry, cream) },
    { shape = mesh.rice { length = 0.022, width = 0.0105, bend = 30 }, material = sugar(orange, mint, lilac) },
    { shape = mesh.sphere { radius = 0.005 }, material = sugar(rose, lemon, mint, cream) },
  },
  scale = { 0.9, 1.1 },
  seed = arg("seed", 4),
}

return scene {
  film = { width = 1280, height = 720, samples = 64, clamp = 8 },
  camera = camera.perspective { from = { 0, 0.66, 0.36 }, at = { 0, 0, 0.006 }, fov = 28, aperture = 0.006 },
  lights = {
    light.sky { zenith = { 0.7, 0.75, 0.85 }, horizon = { 1.0, 0.96, 0.93 }, ground = { 0.4, 0.34, 0.32 }, strength = 0.5 },
    light.area { position = { -1.7, 1.8, -1.0 }, at = { 0, 0, 0 }, size = { 0.9, 0.9 }, color = { 1.0, 0.93, 0.83 }, strength = 23 },
  },
  objects = {
    sweets,
    object { shape = mesh.plane { size = 5 }, material = material.matte { color = srgb("#e9cdc5") } },
  },
}
