-- Leaves, petals and pine needles as paths of SVG, about 2 units long; their stalks point to -x, so
-- that a direction is where their tips go. y points down.
local plants = {}

local function f(...)
  local words = {}
  for i, value in ipairs { ... } do
    words[i] = type(value) == "number" and string.format("%.4f", value) or value
  end
  return table.concat(words, " ") .. " "
end

-- A pine needle: a band that leaves the sheath at one end and bends away to a point.
local function needle(side, spread, bow, thick)
  local y0, y1, y2 = side * 0.02, side * (0.5 * spread + bow), side * spread
  return f("M", -0.92, y0 - thick, "Q", 0.1, y1 - thick, 1, y2, "Q", 0.1, y1 + thick, -0.92, y0 + thick, "Z")
end

-- The pair of needles of a Japanese pine (matsuba), held by a sheath.
local function pine(upper, lower, bow, thick)
  return needle(-1, upper, bow, thick) .. needle(1, lower, bow, thick)
    .. f("M", -1, -0.02, "C", -0.96, -0.05, -0.86, -0.055, -0.8, -0.04, "L", -0.8, 0.04, "C", -0.86, 0.055, -0.96, 0.05, -1, 0.02, "Z")
end
plants.pine = { pine(0.21, 0.15, 0.05, 0.03), pine(0.12, 0.24, -0.03, 0.03), pine(0.17, 0.19, 0.1, 0.03) }
plants.open_pine = { pine(0.5, 0.42, 0.03, 0.055), pine(0.36, 0.54, -0.04, 0.055), pine(0.46, 0.46, 0.1, 0.055) }

-- A half outline, as corners of cubic curves from the stalk to the tip, with its mirror image.
local function mirrored(half)
  local d = f("M", half[1][1], half[1][2])
  for i = 2, #half, 3 do
    d = d .. f("C", half[i][1], half[i][2], half[i + 1][1], half[i + 1][2], half[i + 2][1], half[i + 2][2])
  end
  for i = #half - 1, 2, -3 do
    d = d .. f("C", half[i][1], -half[i][2], half[i - 1][1], -half[i - 1][2], half[i - 2][1], -half[i - 2][2])
  end
  return d .. "Z "
end

-- A petal of the cherry, nicked at its tip; and a rounder one of the plum.
plants.cherry_petal = mirrored {
  { -1, 0.06 }, { -0.8, 0.1 }, { -0.62, 0.3 }, { -0.36, 0.52 }, { 0.0, 0.8 }, { 0.52, 0.72 }, { 0.78, 0.42 },
  { 0.88, 0.3 }, { 0.98, 0.22 }, { 1, 0.14 }, { 0.94, 0.08 }, { 0.84, 0.04 }, { 0.78, 0 },
}
plants.plum_petal = mirrored {
  { -1, 0.08 }, { -0.86, 0.16 }, { -0.76, 0.5 }, { -0.44, 0.76 }, { 0.0, 1.06 }, { 0.86, 0.86 }, { 0.94, 0 },
}

-- Leaves: of the willow, of the beech, and the oak's with its lobes.
plants.willow = mirrored {
  { -1, 0.014 }, { -0.92, 0.012 }, { -0.82, 0.012 }, { -0.74, 0.02 }, { -0.5, 0.16 }, { 0.2, 0.28 }, { 1, 0 },
}
plants.beech = mirrored {
  { -1, 0.022 }, { -0.9, 0.016 }, { -0.8, 0.016 }, { -0.68, 0.024 }, { -0.56, 0.36 }, { -0.2, 0.54 }, { 0.12, 0.5 },
  { 0.46, 0.46 }, { 0.74, 0.2 }, { 1, 0 },
}
plants.oak = mirrored {
  { -1, 0.026 }, { -0.94, 0.02 }, { -0.86, 0.02 }, { -0.78, 0.03 }, { -0.78, 0.16 }, { -0.64, 0.24 }, { -0.54, 0.16 },
  { -0.56, 0.4 }, { -0.3, 0.5 }, { -0.2, 0.26 }, { -0.2, 0.6 }, { 0.16, 0.68 }, { 0.22, 0.32 },
  { 0.26, 0.56 }, { 0.58, 0.54 }, { 0.6, 0.26 }, { 0.72, 0.38 }, { 0.96, 0.26 }, { 0.98, 0 },
}

-- A maple leaf (momiji) of seven fingers and a ginkgo leaf, on their stalks.
plants.maple = (function()
  local tips = { { 132, 0.5 }, { 86, 0.84 }, { 42, 1.02 }, { 0, 1.12 } }
  local function at(angle, radius)
    return { radius * math.cos(math.rad(angle)) - 0.1, radius * math.sin(math.rad(angle)) }
  end
  local half = { { -1, 0.03 }, { -0.7, 0.0 }, { -0.4, 0.02 }, at(172, 0.2) }
  for i, tip in ipairs(tips) do
    local a, r = tip[1], tip[2]
    local before = i == 1 and 172 or (tips[i - 1][1] + a) / 2
    half[#half + 1] = at(before + 0.3 * (a - before), 0.6 * r)
    half[#half + 1] = at(a + 14, 0.72 * r)
    half[#half + 1] = at(a, r)
    if i < #tips then
      local after = (a + tips[i + 1][1]) / 2
      half[#half + 1] = at(a - 14, 0.72 * r)
      half[#half + 1] = at(after + 0.3 * (a - after), 0.6 * r)
      half[#half + 1] = at(after, 0.44)
    end
  end
  return mirrored(half)
end)()
plants.ginkgo = mirrored {
  { -1, 0.035 }, { -0.8, 0.02 }, { -0.6, 0.02 }, { -0.4, 0.035 }, { -0.3, 0.2 }, { -0.12, 0.62 }, { -0.02, 1 },
  { 0.2, 1.02 }, { 0.38, 0.93 }, { 0.5, 0.78 }, { 0.49, 0.7 }, { 0.56, 0.66 }, { 0.62, 0.6 },
  { 0.6, 0.52 }, { 0.68, 0.46 }, { 0.72, 0.4 }, { 0.71, 0.32 }, { 0.76, 0.24 }, { 0.78, 0.14 },
  { 0.62, 0.11 }, { 0.5, 0.05 }, { 0.34, 0 },
}

-- Confetti: a disk, a strip with round ends, and a streamer in waves.
plants.disk = "M -1 0 A 1 1 0 0 1 1 0 A 1 1 0 0 1 -1 0 Z"
plants.strip = "M -0.88 -0.12 L 0.88 -0.12 A 0.12 0.12 0 0 1 0.88 0.12 L -0.88 0.12 A 0.12 0.12 0 0 1 -0.88 -0.12 Z"
plants.streamer = "M -1 -0.06 C -0.8 -0.4 -0.6 -0.4 -0.4 -0.06 C -0.25 0.2 -0.15 0.2 0 -0.06 C 0.2 -0.4 0.4 -0.4 0.6 -0.06 "
  .. "C 0.72 0.14 0.86 0.14 1 -0.06 L 1 0.1 C 0.86 0.32 0.7 0.32 0.54 0.1 C 0.4 -0.16 0.22 -0.16 0.06 0.1 "
  .. "C -0.14 0.4 -0.26 0.4 -0.46 0.1 C -0.6 -0.16 -0.8 -0.16 -1 0.1 Z"

-- The path as a region whose longest side is size [m].
function plants.outline(d, size)
  return region.path { d = d, size = size }
end

-- A bent sheet of it as a component of generator.elements: bends has curl, cup and twist [deg].
function plants.sheet(d, size, material, bends)
  local outline = plants.outline(d, size)
  local sheet = { outline = outline }
  for name, value in pairs(bends or {}) do
    sheet[name] = value
  end
  return { shape = mesh.sheet(sheet), material = material }
end

return plants
