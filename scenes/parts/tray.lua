-- A tray of oak on a table by a window, and the three glazed shapes that the layout figures put on
-- it: e1 is small, e2 and e3 are large, all three concave.
local tray = { width = 1.28, depth = 0.72 }

tray.domain = region.rectangle { width = tray.width, depth = tray.depth }

tray.shapes = {
  e1 = {
    shape = mesh.crescent { radius = 0.0255, waist = 0.7, height = 0.016 },
    material = material.plastic { palette = { srgb("#e7b54a"), srgb("#dda63a"), srgb("#efc568") }, roughness = 0.28 },
  },
  e2 = {
    shape = mesh.l_brick { length = 0.11, height = 0.026, rounding = 0.3 },
    material = material.plastic { palette = { srgb("#b8452f"), srgb("#a83a2a"), srgb("#c4573a") }, roughness = 0.3 },
  },
  e3 = {
    shape = mesh.letter { letter = "S", size = 0.112, height = 0.022 },
    material = material.plastic { palette = { srgb("#2f7f86"), srgb("#28727b"), srgb("#3f9195") }, roughness = 0.26 },
  },
}

-- The rim and the floor of a tray whose inside is width by depth, its floor at y = 0.
function tray.objects(width, depth)
  local wood = material.plastic { color = srgb("#8a5f3c"), roughness = 0.4 }
  local rim, high, below = 0.03, 0.034, 0.016
  local y = (high - below) / 2
  local function beam(w, d, x, z)
    return object {
      shape = mesh.box { width = w, height = high + below, depth = d, rounding = 0.3 },
      position = { x, y, z }, material = wood,
    }
  end
  local gap = 0.012
  local w, d = width + 2 * gap, depth + 2 * gap
  return {
    beam(w + 2 * rim, rim, 0, (d + rim) / 2), beam(w + 2 * rim, rim, 0, -(d + rim) / 2),
    beam(rim, d, (w + rim) / 2, 0), beam(rim, d, -(w + rim) / 2, 0),
    object { -- linen
      shape = mesh.box { width = w, height = below, depth = d, rounding = 0 },
      position = { 0, -below / 2, 0 }, material = material.matte { color = srgb("#e9e1d2") },
    },
    object { -- the table
      shape = mesh.plane { size = 12 }, position = { 0, -below, 0 },
      material = material.matte { color = srgb("#6b7f80") },
    },
  }
end

tray.camera = camera.perspective { from = { 0, 1.62, 0.98 }, at = { 0, 0, 0.03 }, fov = 27.2 }

tray.lights = {
  light.sky { zenith = { 0.62, 0.72, 0.88 }, horizon = { 1.0, 0.97, 0.92 }, ground = { 0.3, 0.28, 0.25 }, strength = 0.5 },
  light.area { position = { -2.4, 2.6, -1.5 }, at = { 0, 0, 0 }, size = { 1.5, 1.5 }, color = { 1.0, 0.92, 0.8 }, strength = 17 },
}

return tray
