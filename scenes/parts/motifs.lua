-- Motifs in the manner of Japanese stencils (katagami), as paths of SVG: what is cut out lets the
-- ground through. Each is about 2 units long; y points down.
local motifs = {}

-- A matte material that gives each element one of these sRGB colors.
function motifs.dye(...)
  local palette = {}
  for i, color in ipairs { ... } do
    palette[i] = srgb(color)
  end
  return material.matte { palette = palette }
end

local function at(angle, radius) -- degrees clockwise from upwards
  local a = math.rad(angle)
  return string.format("%.4f %.4f ", radius * math.sin(a), -radius * math.cos(a))
end

local function ring(angle, distance, radius, clockwise)
  local a = math.rad(angle)
  local x, y = distance * math.sin(a), -distance * math.cos(a)
  local arc = string.format("A %.4f %.4f 0 1 %d ", radius, radius, clockwise and 1 or 0)
  return string.format("M %.4f %.4f ", x - radius, y) .. arc .. string.format("%.4f %.4f ", x + radius, y)
    .. arc .. string.format("%.4f %.4f Z ", x - radius, y)
end

-- A drop whose ends lie at two distances on the ray at an angle, widest towards the outer one.
local function drop(angle, from, to, half_width)
  local span = to - from
  local function side(sign)
    return math.deg(math.atan(sign * half_width, from + 0.72 * span)), from + 0.72 * span
  end
  local left, radius = side(-1)
  local right = side(1)
  return "M " .. at(angle, from) .. "C " .. at(angle + 0.3 * left, from + 0.3 * span) .. at(angle + left * 1.25, radius)
    .. at(angle, to) .. "C " .. at(angle + right * 1.25, radius) .. at(angle + 0.3 * right, from + 0.3 * span)
    .. at(angle, from) .. "Z "
end

-- Petals of one outline; notch is how deep each is nicked, 0 for round ones.
local function blossom(petals, valley, notch)
  local half = 180 / petals
  local d = "M " .. at(-half, valley)
  for i = 0, petals - 1 do
    local a = 2 * half * i
    d = d .. "C " .. at(a - 0.99 * half, 0.8) .. at(a - 0.72 * half, 1.02) .. at(a - 0.2 * half, 1)
    if notch > 0 then
      d = d .. "L " .. at(a, 1 - notch) .. "L " .. at(a + 0.2 * half, 1)
    else
      d = d .. "C " .. at(a - 0.07 * half, 1.005) .. at(a + 0.07 * half, 1.005) .. at(a + 0.2 * half, 1)
    end
    d = d .. "C " .. at(a + 0.72 * half, 1.02) .. at(a + 0.99 * half, 0.8) .. at(a + half, valley)
  end
  return d .. "Z "
end

local function around(count, first, part)
  local d = ""
  for i = 0, count - 1 do
    d = d .. part(first + 360 * i / count)
  end
  return d
end

-- Every motif has an outline, which keeps the others out, and cuts.
motifs.sakura = { -- cherry blossom
  outline = blossom(5, 0.44, 0.15),
  cuts = around(5, 0, function(a) return drop(a, 0.16, 0.52, 0.035) .. ring(a, 0.62, 0.045) end)
    .. around(5, 36, function(a) return drop(a, 0.14, 0.36, 0.03) end),
}

motifs.ume = { -- plum blossom
  outline = blossom(5, 0.62, 0),
  cuts = around(5, 36, function(a) return drop(a, 0.28, 0.58, 0.035) end) .. ring(0, 0, 0.13)
    .. around(5, 0, function(a) return ring(a, 0.36, 0.05) .. ring(a + 17, 0.45, 0.035) .. ring(a - 17, 0.45, 0.035) end),
}

motifs.kiku = { -- chrysanthemum
  outline = blossom(16, 0.86, 0),
  cuts = around(16, 11.25, function(a) return drop(a, 0.34, 0.84, 0.036) end)
    .. around(16, 0, function(a) return drop(a, 0.25, 0.36, 0.02) end) .. ring(0, 0, 0.14),
}

motifs.momiji = (function() -- maple leaf
  local tips = { { -128, 0.5 }, { -84, 0.8 }, { -41, 0.95 }, { 0, 1.05 }, { 41, 0.95 }, { 84, 0.8 }, { 128, 0.5 } }
  local d, veins = "M " .. at(-176, 0.2), ""
  for i, tip in ipairs(tips) do
    local a, r = tip[1], tip[2]
    local before = i == 1 and -176 or (tips[i - 1][1] + a) / 2
    local after = i == #tips and 176 or (tips[i + 1][1] + a) / 2
    local valley = i == #tips and 0.2 or 0.42
    d = d .. "C " .. at(before + 0.3 * (a - before), 0.6 * r) .. at(a - 15, 0.7 * r) .. at(a, r)
      .. "C " .. at(a + 15, 0.7 * r) .. at(after + 0.3 * (a - after), 0.6 * r) .. at(after, valley)
    veins = veins .. drop(a, 0.1, 0.68 * r, 0.02)
  end
  return { outline = d .. "C 0.02 0.4 0.05 0.6 0.13 0.82 L 0.05 0.86 C -0.03 0.6 -0.04 0.4 " .. at(-176, 0.2) .. "Z ", cuts = veins }
end)()

motifs.ginkgo = (function() -- ginkgo leaf
  local outline = "M -0.035 0.42 C -0.2 0.3 -0.62 0.12 -1 0.02 C -1.02 -0.2 -0.93 -0.38 -0.78 -0.5 "
    .. "C -0.7 -0.49 -0.66 -0.56 -0.6 -0.62 C -0.52 -0.6 -0.46 -0.68 -0.4 -0.72 C -0.32 -0.71 -0.24 -0.76 -0.14 -0.78 "
    .. "C -0.11 -0.62 -0.05 -0.5 0 -0.34 C 0.05 -0.5 0.11 -0.62 0.14 -0.78 C 0.24 -0.76 0.32 -0.71 0.4 -0.72 "
    .. "C 0.46 -0.68 0.52 -0.6 0.6 -0.62 C 0.66 -0.56 0.7 -0.49 0.78 -0.5 C 0.93 -0.38 1.02 -0.2 1 0.02 "
    .. "C 0.62 0.12 0.2 0.3 0.035 0.42 C 0.03 0.6 0.06 0.8 0.14 0.98 L 0.05 1 C -0.03 0.8 -0.04 0.6 -0.035 0.42 Z "
  local cuts = ""
  for _, a in ipairs { -62, -46, -31, -16, 16, 31, 46, 62 } do
    local from, to = 0.34, 0.88 -- rays from the foot of the blade
    local s, c = math.sin(math.rad(a)), math.cos(math.rad(a))
    local nx, ny = 0.022 * c, 0.022 * s
    local function point(t, side)
      return string.format("%.4f %.4f ", t * s + side * nx, 0.42 - t * c + side * ny)
    end
    cuts = cuts .. "M " .. point(from, 0) .. "Q " .. point(0.7 * to, 1) .. point(to, 0) .. "Q " .. point(0.7 * to, -1) .. point(from, 0) .. "Z "
  end
  return { outline = outline, cuts = cuts }
end)()

motifs.ogi = (function() -- folding fan
  local open, y = 62, 0.55
  local function point(angle, radius)
    local a = math.rad(angle)
    return string.format("%.4f %.4f ", radius * math.sin(a), y - radius * math.cos(a))
  end
  local function sector(a, b, inner, outer)
    return "M " .. point(a, inner) .. "L " .. point(a, outer) .. string.format("A %.4f %.4f 0 0 1 ", outer, outer) .. point(b, outer)
      .. "L " .. point(b, inner) .. string.format("A %.4f %.4f 0 0 0 ", inner, inner) .. point(a, inner) .. "Z "
  end
  local cuts = ""
  for i = 0, 7 do -- between the ribs
    local a = -open + 4 + i * (2 * open - 8) / 8
    cuts = cuts .. sector(a + 2.6, a + (2 * open - 8) / 8 - 2.6, 0.2, 0.52)
  end
  cuts = cuts .. sector(-open + 5, open - 5, 1.0, 1.04) .. sector(-open + 5, open - 5, 0.62, 0.645)
  for i = -2, 2 do -- dots on the paper
    local a = math.rad(22 * i)
    local x, z = 0.82 * math.sin(a), y - 0.82 * math.cos(a)
    cuts = cuts .. string.format("M %.4f %.4f A 0.07 0.07 0 1 0 %.4f %.4f A 0.07 0.07 0 1 0 %.4f %.4f Z ", x - 0.07, z, x + 0.07, z, x - 0.07, z)
  end
  return { outline = sector(-open, open, 0.07, 1.12), cuts = cuts }
end)()

motifs.chidori = { -- plover
  outline = "M -1.02 -0.2 C -0.9 -0.26 -0.86 -0.3 -0.8 -0.38 C -0.7 -0.52 -0.5 -0.55 -0.36 -0.46 "
    .. "C -0.22 -0.72 0.1 -0.95 0.52 -0.98 C 0.38 -0.84 0.4 -0.74 0.3 -0.6 C 0.5 -0.62 0.6 -0.58 0.72 -0.6 "
    .. "C 0.56 -0.46 0.5 -0.34 0.38 -0.22 C 0.56 -0.1 0.8 -0.08 1.06 -0.14 C 0.94 0.02 0.9 0.06 0.78 0.14 "
    .. "C 0.84 0.2 0.9 0.24 0.98 0.28 C 0.8 0.38 0.6 0.36 0.48 0.34 C 0.3 0.6 -0.1 0.68 -0.4 0.52 "
    .. "C -0.66 0.38 -0.8 0.14 -0.8 -0.08 C -0.88 -0.12 -0.94 -0.14 -1.02 -0.2 Z ",
  cuts = "M -0.6 -0.26 A 0.055 0.055 0 1 0 -0.49 -0.26 A 0.055 0.055 0 1 0 -0.6 -0.26 Z "
    .. "M -0.28 -0.1 C -0.16 0.12 0.1 0.2 0.32 0.06 C 0.1 0.14 -0.1 0.08 -0.28 -0.1 Z "
    .. "M -0.34 0.08 C -0.2 0.34 0.14 0.4 0.38 0.2 C 0.14 0.31 -0.12 0.26 -0.34 0.08 Z "
    .. "M -0.16 -0.42 C -0.06 -0.6 0.1 -0.74 0.3 -0.82 C 0.14 -0.68 0.02 -0.56 -0.04 -0.4 C -0.07 -0.36 -0.14 -0.37 -0.16 -0.42 Z ",
}

-- Fish, looking along +x: a carp and a slim one.
motifs.carp = {
  outline = "M 1 0 C 0.98 -0.1 0.84 -0.21 0.64 -0.26 C 0.6 -0.42 0.44 -0.52 0.3 -0.55 C 0.36 -0.45 0.36 -0.37 0.34 -0.3 "
    .. "C 0.08 -0.31 -0.2 -0.24 -0.42 -0.13 C -0.52 -0.09 -0.6 -0.1 -0.68 -0.17 C -0.78 -0.27 -0.9 -0.36 -1.04 -0.38 "
    .. "C -0.96 -0.24 -0.9 -0.1 -0.88 0 C -0.9 0.1 -0.96 0.24 -1.04 0.38 C -0.9 0.36 -0.78 0.27 -0.68 0.17 "
    .. "C -0.6 0.1 -0.52 0.09 -0.42 0.13 C -0.2 0.24 0.08 0.31 0.34 0.3 C 0.36 0.37 0.36 0.45 0.3 0.55 "
    .. "C 0.44 0.52 0.6 0.42 0.64 0.26 C 0.84 0.21 0.98 0.1 1 0 Z ",
  cuts = "M 0.62 -0.2 C 0.5 -0.08 0.5 0.08 0.62 0.2 C 0.55 0.08 0.55 -0.08 0.62 -0.2 Z "
    .. "M 0.36 -0.2 C 0.24 -0.07 0.24 0.07 0.36 0.2 C 0.29 0.07 0.29 -0.07 0.36 -0.2 Z "
    .. "M 0.1 -0.19 C -0.02 -0.07 -0.02 0.07 0.1 0.19 C 0.03 0.07 0.03 -0.07 0.1 -0.19 Z "
    .. "M -0.16 -0.14 C -0.26 -0.05 -0.26 0.05 -0.16 0.14 C -0.21 0.05 -0.21 -0.05 -0.16 -0.14 Z "
    .. "M 0.74 -0.12 A 0.03 0.03 0 1 0 0.8 -0.12 A 0.03 0.03 0 1 0 0.74 -0.12 Z "
    .. "M 0.74 0.12 A 0.03 0.03 0 1 0 0.8 0.12 A 0.03 0.03 0 1 0 0.74 0.12 Z ",
}

-- A component of the layout from a motif, its longest side size long.
function motifs.component(name, size, material, margin)
  local motif = motifs[name]
  return {
    shape = region.path { d = motif.outline .. motif.cuts, fill_rule = "evenodd", size = size },
    region = region.path { d = motif.outline, size = size },
    material = material, margin = margin, height = size / 150,
  }
end

return motifs
