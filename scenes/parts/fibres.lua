-- Light that shows fibres one by one.
local fibres = {}

-- For things `size` large: a small warm key low from the left, a cool rim from behind on the right,
-- little fill.
function fibres.lights(size, strength)
  strength = strength or 1
  return {
    light.area {
      position = { -8 * size, 6 * size, 3 * size }, at = { 0, 0.4 * size, 0 }, size = { 2 * size, 2 * size },
      color = { 1.0, 0.92, 0.8 }, strength = 80 * strength,
    },
    light.area {
      position = { 8 * size, 8 * size, -9 * size }, at = { 0, 0.4 * size, 0 }, size = { 3 * size, 4 * size },
      color = { 0.8, 0.89, 1.0 }, strength = 15 * strength,
    },
    light.sky { color = { 0.75, 0.85, 1.0 }, strength = 0.16 * strength },
  }
end

return fibres
