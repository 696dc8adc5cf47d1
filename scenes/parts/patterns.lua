-- Round motifs from traditional Japanese patterns, as paths of SVG about 2 units wide. Every motif has
-- an outline, which keeps the others out, and cuts, which let the ground through.
local patterns = {}

local function at(angle, radius, x, y) -- degrees clockwise from upwards
  local a = math.rad(angle)
  return string.format("%.4f %.4f ", (x or 0) + radius * math.sin(a), (y or 0) - radius * math.cos(a))
end

local function polygon(corners)
  return "M " .. table.concat(corners, "L ") .. "Z "
end

local function circle(radius, x, y)
  x, y = x or 0, y or 0
  return string.format("M %.4f %.4f A %.4f %.4f 0 1 0 %.4f %.4f A %.4f %.4f 0 1 0 %.4f %.4f Z ", x - radius, y, radius, radius,
    x + radius, y, radius, radius, x - radius, y)
end

local function around(count, first, part)
  local d = ""
  for i = 0, count - 1 do
    d = d .. part(first + 360 * i / count)
  end
  return d
end

-- A lens between two points of equal distance from the middle, bulging by a share of its length.
local function lens(a, b, r, bulge)
  local ax, ay = r * math.sin(math.rad(a)), -r * math.cos(math.rad(a))
  local bx, by = r * math.sin(math.rad(b)), -r * math.cos(math.rad(b))
  local mx, my, nx, ny = (ax + bx) / 2, (ay + by) / 2, (by - ay) * bulge, (ax - bx) * bulge
  return string.format("M %.4f %.4f Q %.4f %.4f %.4f %.4f Q %.4f %.4f %.4f %.4f Z ", ax, ay, mx + nx, my + ny, bx, by, mx - nx, my - ny, ax, ay)
end

-- Hemp leaf: a hexagon whose rhombs and triangles are outlined by gaps.
patterns.asanoha = {
  outline = polygon { at(0, 1), at(60, 1), at(120, 1), at(180, 1), at(240, 1), at(300, 1) },
  cuts = around(6, 0, function(a)
    local function inner(distance, turn) return at(a + turn, distance) end
    -- Two slim triangles beside each spoke, and one along each side.
    return polygon { inner(0.13, 12), inner(0.86, 2.6), inner(0.52, 23) }
      .. polygon { inner(0.13, -12), inner(0.86, -2.6), inner(0.52, -23) }
      .. polygon { inner(0.9, 6.5), inner(0.9, 53.5), inner(0.62, 30) }
  end),
}

-- Seven treasures: a disk with the four petals of circles that meet in it.
patterns.shippo = {
  outline = circle(1),
  cuts = around(4, 45, function(a) return lens(a - 45, a + 45, 0.86, 0.3) end)
    .. "M 0 -0.5 Q 0.14 -0.14 0.5 0 Q 0.14 0.14 0 0.5 Q -0.14 0.14 -0.5 0 Q -0.14 -0.14 0 -0.5 Z ",
}

-- Temari: a ball wound with thread, with a star of eight and a belt of lozenges.
patterns.temari = {
  outline = circle(1),
  cuts = around(8, 0, function(a)
    return polygon { at(a, 0.56), at(a + 7, 0.3), at(a, 0.12), at(a - 7, 0.3) }
      .. polygon { at(a + 22.5, 0.88), at(a + 33, 0.72), at(a + 22.5, 0.5), at(a + 12, 0.72) }
  end) .. around(8, 0, function(a) return circle(0.055, 0.8 * math.sin(math.rad(a)), -0.8 * math.cos(math.rad(a))) end),
}

return patterns
