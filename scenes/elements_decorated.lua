-- Elements inside drawn regions over a background, as in figure 6 of Kita & Miyata (2012): a
-- long-sleeved kimono on its rack. Blossoms of four kinds and petals grow towards the hem;
-- hexagons cover the sash.
local motifs = include("parts/motifs.lua")
local plants = include("parts/plants.lua")
local seed = arg("seed", 3)

local dye = motifs.dye
local unit = 0.6 -- metres per unit of the drawing

local kimono = "M -0.12 -0.98 L -1.0 -0.88 L -1.06 0.36 C -1.06 0.46 -1.02 0.5 -0.93 0.5 L -0.5 0.5 L -0.46 -0.3 L -0.4 -0.3 "
  .. "C -0.4 0.2 -0.44 0.7 -0.56 1.26 C -0.2 1.31 0.2 1.31 0.56 1.26 C 0.44 0.7 0.4 0.2 0.4 -0.3 L 0.46 -0.3 L 0.5 0.5 L 0.93 0.5 "
  .. "C 1.02 0.5 1.06 0.46 1.06 0.36 L 1.0 -0.88 L 0.12 -0.98 L 0.1 -0.88 C 0.04 -0.84 -0.04 -0.84 -0.1 -0.88 Z "
local neck = "M -0.16 -1.0 C -0.14 -0.84 0.14 -0.84 0.16 -1.0 Z "
local collar = "M -0.18 -1.0 C -0.17 -0.8 0.17 -0.8 0.18 -1.0 L 0.13 -1.0 C 0.11 -0.88 -0.11 -0.88 -0.13 -1.0 Z "
local sash = "M -0.415 -0.2 L 0.415 -0.2 L 0.42 0.12 L -0.42 0.12 Z "
local knot = "M -0.2 -0.27 C -0.07 -0.3 0.07 -0.3 0.2 -0.27 L 0.22 0.2 C 0.07 0.23 -0.07 0.23 -0.22 0.2 Z "
local cord = "M -0.418 -0.06 L 0.418 -0.06 L 0.418 -0.025 L -0.418 -0.025 Z "
-- What shows of sash and knot beside and between knot and cord.
local sash_cloth = "M -0.41 -0.195 H -0.225 V -0.065 H -0.412 Z M -0.412 -0.02 H -0.225 V 0.115 H -0.415 Z "
  .. "M 0.41 -0.195 H 0.225 V -0.065 H 0.412 Z M 0.412 -0.02 H 0.225 V 0.115 H 0.415 Z "
local knot_cloth = "M -0.195 -0.262 C -0.07 -0.29 0.07 -0.29 0.195 -0.262 L 0.2 -0.065 H -0.2 Z "
  .. "M -0.203 -0.02 H 0.203 L 0.215 0.195 C 0.07 0.223 -0.07 0.223 -0.215 0.195 Z "
-- What blossoms keep out of: sash and knot in one, and the collar.
local covered = "M -0.5 -0.2 L -0.2 -0.2 L -0.2 -0.28 C -0.07 -0.31 0.07 -0.31 0.2 -0.28 L 0.2 -0.2 L 0.5 -0.2 L 0.5 0.12 "
  .. "L 0.22 0.12 L 0.23 0.21 C 0.07 0.24 -0.07 0.24 -0.23 0.21 L -0.22 0.12 L -0.5 0.12 Z "

local function drawn(d)
  return region.path { d = d, scale = unit, centred = false }
end

-- A flat piece of cloth where it was drawn; box is the drawing's extent, which the sheet is centred by.
local function cloth(d, x, z, thickness, y, color)
  return object {
    shape = mesh.sheet { outline = drawn(d), thickness = thickness },
    position = { x * unit, y, z * unit }, material = material.matte { color = srgb(color) },
  }
end

local function blossom(name, size, weight, ...)
  local component = motifs.component(name, size, dye(...), 0.0025)
  component.weight, component.height = weight, 0.0062
  return component
end

local hexagon = "M 1 0 L 0.5 0.866 L -0.5 0.866 L -1 0 L -0.5 -0.866 L 0.5 -0.866 Z "
local function nested(d, ...) -- the outline again, smaller
  for _, scale in ipairs { ... } do
    d = d .. string.format("M %.3f 0 L %.3f %.3f L %.3f %.3f L %.3f 0 L %.3f %.3f L %.3f %.3f Z ", scale, scale / 2, scale * 0.866,
      -scale / 2, scale * 0.866, -scale, -scale / 2, -scale * 0.866, scale / 2, -scale * 0.866)
  end
  return d
end

local function hexagons(d, size, y, ...)
  return generator.elements {
    domain = drawn(d), inside = "whole",
    components = { {
      shape = region.path { d = nested(hexagon, 0.78, 0.56, 0.3), fill_rule = "evenodd", size = size },
      region = region.path { d = hexagon, size = size }, material = dye(...), margin = 0.0008, height = y,
    } },
    rotation = { 0, 60 }, seed = seed,
  }
end

local lacquer = material.plastic { color = srgb("#1a1214"), roughness = 0.2 }
local function beam(x, z, width, depth)
  return object {
    shape = mesh.box { width = width * unit, height = 0.03, depth = depth * unit, rounding = 0.5 },
    position = { x * unit, -0.034, z * unit }, material = lacquer,
  }
end

return scene {
  film = { width = 960, height = 960, samples = 64, clamp = 8 },
  camera = camera.perspective { from = { 0, 6, 0.12 }, at = { 0, 0, 0.08 }, up = { 0, 0, -1 }, fov = 15.6 },
  lights = {
    light.sky { color = { 0.97, 0.98, 1.0 }, strength = 0.6 },
    light.sun { direction = { -1, 1.2, -0.8 }, angle = 5, color = { 1, 0.94, 0.84 }, strength = 1.8 },
  },
  objects = {
    generator.elements {
      domain = region.path { d = kimono .. covered .. collar, fill_rule = "evenodd", scale = unit, centred = false },
      inside = "whole",
      components = {
        blossom("sakura", 0.088, 3, "#f0c3c9", "#f6dcd8", "#eaa8b4"),
        blossom("kiku", 0.088, 2, "#d9a441", "#f1e3c4", "#e3bd6a"),
        blossom("ume", 0.08, 2, "#c8452f", "#f3eadb", "#d96a58"),
        blossom("momiji", 0.088, 2, "#d9743a", "#c8452f", "#8fae8b"),
        { -- petals, as many as find room between the others
          shape = plants.outline(plants.cherry_petal, 0.028), material = dye("#f0c3c9", "#f6dcd8"), weight = 10,
          margin = 0.0025, height = 0.0062,
        },
      },
      rotation = { 0, 360 },
      scale_by = field.gradient { from = { 0, -0.98 * unit }, to = { 0, 1.2 * unit }, low = 0.5, high = 1.05 },
      seed = seed,
    },
    hexagons(sash_cloth, 0.026, 0.0085, "#b03a2e", "#c24a35", "#a3332c"),
    hexagons(knot_cloth, 0.03, 0.0125, "#2f7f8c", "#b03a2e", "#25616d"),
    cloth(kimono, 0, 0.15, 0.005, 0, "#22335c"),
    cloth(neck, 0, -0.94, 0.004, 0.003, "#a8392c"),
    cloth(collar, 0, -0.925, 0.005, 0.005, "#efe6d6"),
    cloth(sash, 0, -0.04, 0.004, 0.004, "#e2c27a"),
    cloth(knot, 0, -0.04, 0.004, 0.008, "#e2c27a"),
    cloth(cord, 0, -0.0425, 0.006, 0.0125, "#2f7f8c"),
    beam(0, -0.93, 2.7, 0.05), beam(-1.25, 0.25, 0.05, 2.46), beam(1.25, 0.25, 0.05, 2.46),
    beam(-1.25, 1.46, 0.36, 0.07), beam(1.25, 1.46, 0.36, 0.07),
    object { shape = mesh.plane { size = 8 }, position = { 0, -0.05, 0 }, material = material.matte { color = srgb("#dccba3") } },
  },
}
