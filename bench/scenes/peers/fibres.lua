-- 2,000 curved fibres over a floor under a constant sky and an area light, all grey.
math.randomseed(7)
local grey = material.matte { color = { 0.6, 0.6, 0.6 } }

local function gauss(deviation) -- Box & Muller 1958
  return deviation * math.sqrt(-2 * math.log(1 - math.random())) * math.cos(2 * math.pi * math.random())
end
local function unit(v)
  local length = math.sqrt(v[1] * v[1] + v[2] * v[2] + v[3] * v[3])
  return { v[1] / length, v[2] / length, v[3] / length }
end

local strands = {}
for fibre = 1, 2000 do
  local p = { 22 * math.random() - 11, 0.3 + 3.7 * math.random(), 22 * math.random() - 11 }
  local d = unit { gauss(1), gauss(0.25), gauss(1) }
  local bend = { gauss(0.06), gauss(0.06), gauss(0.06) }
  local points = { { p[1], p[2], p[3] } }
  for step = 1, 32 do
    for axis = 1, 3 do
      bend[axis] = 0.9 * bend[axis] + gauss(0.05)
      d[axis] = d[axis] + bend[axis]
    end
    d = unit { d[1], 0.9 * d[2], d[3] }
    for axis = 1, 3 do
      p[axis] = p[axis] + 0.2 * d[axis]
    end
    if p[2] < 0.1 then
      p[2], d[2] = 0.1, math.abs(d[2])
    end
    points[#points + 1] = { p[1], p[2], p[3] }
  end
  strands[fibre] = { points = points, radius = 0.05 }
end

return scene {
  film = { width = 320, height = 180, depth = 6, filter = "box", radius = 0.5 },
  camera = camera.perspective { from = { 16, 17, 24 }, at = { 0, 1.5, 0 }, fov = 36 },
  lights = {
    light.sky { color = { 0.6, 0.6, 0.6 } },
    light.area { position = { -10, 22, 10 }, at = { -10, 0, 10 }, size = { 8, 8 }, strength = 12 },
  },
  objects = {
    object { shape = mesh.plane { size = 100 }, scale = { 4, 1, 4 }, material = grey },
    object { shape = curve.spline { strands = strands }, material = grey },
  },
}
