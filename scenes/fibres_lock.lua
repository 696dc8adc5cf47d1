-- Three locks of hair: brown, blond and of clear fibres. Light goes through many fibres of the
-- bright ones, so that paths are long.
local strands = include("parts/strands.lua")
math.randomseed(arg("seed", 2))

-- Absorption [1/radius] by pigment: eumelanin, which makes hair dark, and pheomelanin, reddish (d'Eon
-- et al. 2011).
local function hair(eumelanin, pheomelanin)
  local absorption = {}
  for k, e in ipairs({ 0.419, 0.697, 1.37 }) do
    absorption[k] = eumelanin * e + pheomelanin * ({ 0.187, 0.4, 1.05 })[k]
  end
  return material.fibre { absorption = absorption, beta_m = 0.25, beta_n = 0.3 }
end

local shape = { length = 0.26, width = 0.022, swing = 0.022, waves = 1.6, radius = mm(0.06) }
local function lock(x, look)
  return object {
    shape = curve.spline { strands = strands.lock(arg("strands", 2500), shape) },
    material = look, position = { x, 0.13, 0 },
  }
end

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 256), depth = 100 },
  camera = camera.perspective { from = { 0, 0.02, 1 }, at = { 0, -0.005, 0 }, fov = 16.5 },
  lights = {
    light.sky { strength = 0.5 },
    light.area { position = { -0.5, 0.6, 0.5 }, size = { 0.3, 0.3 }, strength = 30 },
    light.area { position = { 0.5, 0.4, -0.5 }, size = { 0.3, 0.3 }, strength = 24 },
  },
  objects = {
    lock(-0.11, hair(1.3, 0)), lock(0, hair(0.3, 0.1)), lock(0.11, material.fibre { color = 1, beta_m = 0.25 }),
    object { shape = mesh.plane { size = 20 }, rotation = { 90, 0, 0 }, position = { 0, 0, -0.6 }, material = material.matte { color = 0.18 } },
  },
}
