-- A heap of autumn leaves: thin sheets, each a little bent, piled up over a mound.
local pile = include("parts/pile.lua")
local plants = include("parts/plants.lua")

local function foliage(...)
  return material.plastic { palette = pile.palette(...), roughness = 0.5 }
end
local reds = foliage("#a5331f", "#b84a22", "#8c2a1e", "#c2622a", "#7a2f22")
local golds = foliage("#d9a32e", "#c98f26", "#e0b544", "#b87f2c")
local browns = foliage("#8a5a34", "#76492b", "#9c6b3e")

-- From the middle of its foot up to its top.
local mound = mesh.lathe {
  profile = { { 0, 0 }, { 0.30, 0 }, { 0.29, 0.02 }, { 0.24, 0.06 }, { 0.16, 0.115 }, { 0.07, 0.145 }, { 0, 0.15 } },
}

local function leaf(d, size, paint, bends, weight)
  local component = plants.sheet(d, size, paint, bends)
  component.sheet = true
  component.weight = weight
  component.variation = { shapes = 6, bend = 30, twist = 20, scale = { 0.75, 1.2 } }
  return component
end

return scene {
  film = { width = 1280, height = 720, samples = 128, clamp = 4, depth = 10 },
  camera = camera.perspective { from = { -0.2, 0.5, 1.1 }, at = { 0, 0.055, 0 }, fov = 22 },
  lights = {
    light.sky { zenith = { 0.5, 0.68, 1.0 }, horizon = { 1.0, 0.97, 0.92 }, ground = { 0.3, 0.27, 0.2 }, strength = 0.8 },
    light.sun { direction = { -1.0, 0.9, 0.5 }, angle = 3, color = { 1.0, 0.9, 0.75 }, strength = 3 },
  },
  objects = {
    object { shape = mesh.plane { size = 60 }, material = material.matte { color = srgb("#7d8466") } },
    generator.pile {
      target = mound,
      components = {
        leaf(plants.maple, 0.075, reds, { curl = 25, cup = 20 }, 3),
        leaf(plants.ginkgo, 0.055, golds, { curl = -20, cup = 15 }, 3),
        leaf(plants.maple, 0.06, browns, { curl = 60, cup = 40 }, 2),
      },
      rotation = { 50, 360, 50 }, position = { 0, mm(3), 0 }, cover = arg("cover", 0.93), seed = arg("seed", 1),
    },
  },
}
