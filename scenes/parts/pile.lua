-- What the scenes of heaps share: shapes to be covered, a table top and its light.
local pile = {}

-- Colours of the screen as a material's palette.
function pile.palette(...)
  local colors = {}
  for i, tone in ipairs { ... } do colors[i] = srgb(tone) end
  return colors
end

-- A breaking wave `size` long that runs to the left; its foot is flat.
function pile.wave(size)
  return mesh.extrude {
    outline = region.path {
      d = "M0 100 C6 84 10 58 30 38 C50 18 78 14 92 34 C101 48 92 64 78 62 C68 60 66 50 72 45 C58 44 50 56 56 68 C62 80 84 82 104 74 C124 66 146 72 160 88 L160 100 Z",
      size = size,
    },
    height = 0.42 * size, rounding = 0.06 * size, upright = true,
  }
end

-- A rice ball: a rounded triangle that stands.
function pile.rice_ball(size)
  return mesh.extrude {
    outline = region.path {
      d = "M50 4 C60 4 66 10 72 20 L96 64 C102 76 96 88 82 88 L18 88 C4 88 -2 76 4 64 L28 20 C34 10 40 4 50 4 Z",
      size = size,
    },
    height = 0.45 * size, rounding = 0.2 * size, upright = true,
  }
end

-- Steamed rice: light goes a third of a millimetre into a grain before it is scattered, and a film
-- of starch and water lies on it.
function pile.steamed_rice()
  return material.translucent {
    palette = pile.palette("#f3ebd8", "#efe5ce", "#f6f0e0", "#ece1c8", "#f2ebdb"),
    distance = mm(0.35), spread = { 1, 0.95, 0.85 }, roughness = 0.14, ior = 1.42,
  }
end

-- A table top for things `size` large.
function pile.table_top(size, color)
  return object {
    shape = mesh.plane { size = 300 * size },
    material = material.plastic { color = color or srgb("#3a2a20"), roughness = 0.35 },
  }
end

-- A large soft key from the left, a cool rim from behind on the right.
function pile.lights(size, strength)
  strength = strength or 1
  return {
    light.area {
      position = { -7 * size, 10 * size, 7 * size }, at = { 0, 0.5 * size, 0 }, size = { 6 * size, 6 * size },
      color = { 1.0, 0.94, 0.86 }, strength = 13 * strength,
    },
    light.area {
      position = { 8 * size, 7 * size, -7 * size }, at = { 0, 0.5 * size, 0 }, size = { 4 * size, 4 * size },
      color = { 0.82, 0.9, 1.0 }, strength = 9 * strength,
    },
    light.sky { zenith = { 0.7, 0.8, 1.0 }, horizon = { 1, 0.98, 0.95 }, ground = { 0.3, 0.26, 0.22 }, strength = 0.45 * strength },
  }
end

return pile
