-- Cherry petals on dark water, a raft that the current draws out around open water: three tints of
-- petal, each evenly spread by itself and all together, turned with the current.
local plants = include("parts/plants.lua")

local function tint(...)
  local palette = {}
  for i, color in ipairs { ... } do
    palette[i] = srgb(color)
  end
  return material.plastic { palette = palette, roughness = 0.55, ior = 1.3 }
end

local function petal(size, weight, dye, bends)
  local component = plants.sheet(plants.cherry_petal, size, dye, bends)
  component.weight, component.margin, component.height = weight, mm(0.3), mm(0.2)
  return component
end

-- A raft of petals between two shores of open water.
local raft = "M -1.5 -0.05 C -0.8 -0.02 -0.55 -0.2 -0.25 -0.34 C 0.1 -0.5 0.5 -0.6 0.7 -1.0 L 1.7 -1.0 C 1.3 -0.5 0.9 -0.34 0.6 -0.2 "
  .. "C 0.36 -0.08 0.4 0.06 0.2 0.2 C 0.06 0.3 -0.2 0.26 -0.34 0.5 L -1.5 0.8 Z "
  .. "M -0.5 0.08 C -0.42 0.0 -0.24 -0.04 -0.16 0.02 C -0.1 0.08 -0.2 0.14 -0.32 0.15 C -0.42 0.16 -0.54 0.14 -0.5 0.08 Z"

local petals = generator.elements {
  domain = region.path { d = raft, fill_rule = "evenodd", centred = false },
  components = {
    petal(mm(27), 4, tint("#f6d3da", "#f3c6d0", "#f9dfe3"), { curl = 38, cup = 52 }),
    petal(mm(26), 4, tint("#f2b6c5", "#eeaabb", "#f4c2ce"), { curl = 64, cup = 40, twist = 14 }),
    petal(mm(25), 3, tint("#fbeeee", "#f8e4e4"), { curl = 24, cup = 70, twist = -16 }),
  },
  direction = field.function { -- along the current, in waves
    width = 3.4, depth = 2, angle = true,
    value = function(x, z) return -25 + 30 * math.sin(5 * x + 2 * z) + 20 * math.sin(9 * z - 3 * x) end,
  },
  rotation = { -40, 40 },
  seed = arg("seed", 2),
}

return scene {
  film = { width = 1280, height = 720, samples = 64, clamp = 8, exposure = 0.5 },
  camera = camera.perspective { from = { 0, 0.44, 0.7 }, at = { 0, 0, -0.03 }, fov = 34, aperture = 0.008 },
  lights = {
    light.sky { zenith = { 0.3, 0.42, 0.6 }, horizon = { 0.75, 0.85, 0.95 }, ground = { 0.1, 0.12, 0.13 }, strength = 0.7 },
    light.sun { direction = { 1.3, 0.8, -0.3 }, angle = 2.5, color = { 1, 0.93, 0.84 }, strength = 2.6 },
  },
  objects = {
    petals,
    object { -- water
      shape = mesh.plane { size = 60 },
      material = material.plastic { color = srgb("#0d2a33"), roughness = 0.06, ior = 1.33 },
    },
  },
}
