-- The stone and the timber of figures 10 to 15 of Okada et al. (1987): one lattice of 65^3 numbers,
-- 10 cm wide, for all; and the studio in which the figures stand.
local solid = { edge = 0.1 }

-- Puts the lattice's cube where a box of that edge stands.
solid.corner = { -solid.edge / 2, 0, -solid.edge / 2 }

local function filled(settings, more)
  for name, value in pairs(more or {}) do settings[name] = value end
  return settings
end

-- k is 16 in the figures.
function solid.marble(more)
  return material.plastic {
    color = procedural.marble(filled({ preset = "banded", size = solid.edge, levels = 6, turbulence = 16 }, more)),
    roughness = 0.18,
  }
end

-- k is 1.6 in the figures.
function solid.wood(more)
  return material.plastic {
    color = procedural.wood(filled({ preset = "paper", size = solid.edge, levels = 6, turbulence = 1.6 }, more)),
    roughness = 0.35,
  }
end

function solid.studio(objects)
  objects[#objects + 1] = object {
    shape = mesh.plane { size = 40 }, material = material.matte { color = { 0.36, 0.36, 0.37 } },
  }
  return objects
end

-- A large soft key from the left, a cool rim from behind on the right, for things `size` large.
function solid.lights(size)
  return {
    light.area {
      position = { -9 * size, 12 * size, 9 * size }, at = { 0, 0.4 * size, 0 }, size = { 8 * size, 8 * size },
      color = { 1.0, 0.95, 0.87 }, strength = 14,
    },
    light.area {
      position = { 10 * size, 8 * size, -9 * size }, at = { 0, 0.4 * size, 0 }, size = { 7 * size, 7 * size },
      color = { 0.8, 0.9, 1.0 }, strength = 6,
    },
    light.sky { color = { 0.93, 0.96, 1.0 }, strength = 0.55 },
  }
end

return solid
