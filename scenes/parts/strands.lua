-- Points of strands.
local parts = {}

-- Turns the vectors a and b of a frame towards each other in their plane.
local function turn(a, b, angle)
  local c, s = math.cos(angle), math.sin(angle)
  local p, q = {}, {}
  for k = 1, 3 do
    p[k] = c * a[k] + s * b[k]
    q[k] = c * b[k] - s * a[k]
  end
  return p, q
end

local function between(range) return math.rad(range[1] + (range[2] - range[1]) * math.random()) end

-- A chain of equal segments that begins upwards: in a frame that is carried along, with y along the
-- segment, the next one turns by theta about z and then by phi about y, each at random in its range
-- [deg]. Its bounding box is centred on the origin.
function parts.staple_fibre(length, segments, theta, phi)
  local x, y, z = { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }
  local points = { { 0, 0, 0 } }
  local low, high = { 0, 0, 0 }, { 0, 0, 0 }
  for i = 1, segments do
    local p = {}
    for k = 1, 3 do
      p[k] = points[i][k] + y[k] * length / segments
      low[k], high[k] = math.min(low[k], p[k]), math.max(high[k], p[k])
    end
    points[i + 1] = p
    x, y = turn(x, y, between(theta))
    z, x = turn(z, x, between(phi))
  end
  for _, p in ipairs(points) do
    for k = 1, 3 do p[k] = p[k] - (low[k] + high[k]) / 2 end
  end
  return points
end

-- A lock of hair that hangs down from the origin: `count` strands about a wavy middle line, which a
-- part of them leaves towards the tip. The parts of `shape` are lengths [m], but for `waves`.
function parts.lock(count, shape)
  local strands = {}
  local steps = 24
  for i = 1, count do
    local around = 2 * math.pi * math.random()
    local out = math.sqrt(math.random())
    local length = shape.length * (0.88 + 0.12 * math.random())
    local stray = math.random() ^ 6
    local phase = 6.3 * math.random()
    local points, radii = {}, {}
    for k = 0, steps do
      local t = k / steps
      local wave = 2 * math.pi * shape.waves * t
      local narrow = 1 - 0.75 * t ^ 1.5 + 1.6 * stray * t * t
      local r = shape.width * out * narrow
      local a = around + 2.2 * t
      local own = shape.width * 0.12 * t * (0.4 + stray)
      points[k + 1] = {
        shape.swing * t * math.sin(wave) + r * math.cos(a) + own * math.sin(9 * t + phase),
        -length * t,
        0.6 * shape.swing * t * math.cos(wave) + 0.6 * r * math.sin(a) + own * math.cos(7 * t + phase),
      }
      radii[k + 1] = shape.radius * (1 - 0.7 * t ^ 3)
    end
    strands[i] = { points = points, radius = radii }
  end
  return strands
end

return parts
