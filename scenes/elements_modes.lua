-- Four ways to keep distance, as in figure 2 of Kita & Miyata (2012): disks; ellipses in a whirl;
-- three classes, each evenly spread and all together; ellipses of three classes in a whirl.
-- --set mode=isotropic, anisotropic, multiclass or anisotropic_multiclass: one of them alone.
local mode = arg("mode", "all")
local seed = arg("seed", 1)

local side, gap = 1, 0.06
local ink = srgb("#27364b")
local dyes = { srgb("#d8563a"), srgb("#e0a83c"), srgb("#2f7f8c") }
local paper = material.matte { color = srgb("#f3ecdd") }

-- Elements that fill a panel about (x, z): disks, or ellipses of the same area three times as long as
-- wide that go round its middle. Of three sizes the smaller are the more frequent.
local function panel(x, z, anisotropic, classes)
  local stretch = anisotropic and math.sqrt(3) or 1
  local radii = classes == 1 and { 0.0165 } or { 0.0145, 0.019, 0.0245 }
  local components = {}
  for i, radius in ipairs(radii) do
    local a, b = stretch, 1 / stretch
    components[i] = {
      shape = region.path {
        d = string.format("M %.4f 0 A %.4f %.4f 0 0 1 %.4f 0 A %.4f %.4f 0 0 1 %.4f 0 Z", -a, a, b, a, a, b, -a),
        scale = radius * 0.94,
      },
      margin = radius * (anisotropic and 0.08 or 0.06), weight = (radii[1] / radius) ^ 2,
      material = material.matte { color = classes == 1 and ink or dyes[i] },
    }
  end
  local half = side / 2
  local d = string.format("M %f %f H %f V %f H %f Z ", x - half, z - half, x + half, z + half, x - half)
  if anisotropic then -- in the eye of the whirl directions change too fast for ellipses
    d = d .. string.format("M %f %f a 0.07 0.07 0 1 1 0.14 0 a 0.07 0.07 0 1 1 -0.14 0 Z", x - 0.07, z)
  end
  return generator.elements {
    domain = region.path { d = d, fill_rule = "evenodd", centred = false },
    inside = "whole",
    components = components,
    direction = anisotropic and field.whirl { centre = { x, z }, turn = 90 } or nil,
    rotation = anisotropic and { -3, 3 } or nil, -- room for what the whirl turns between two
    seed = seed,
  }
end

local modes = {
  isotropic = { false, 1 }, anisotropic = { true, 1 }, multiclass = { false, 3 }, anisotropic_multiclass = { true, 3 },
}
local order = { "isotropic", "anisotropic", "multiclass", "anisotropic_multiclass" }
assert(mode == "all" or modes[mode], "mode: all, " .. table.concat(order, ", "))

local objects = {
  object { shape = mesh.plane { size = 8 }, position = { 0, -0.01, 0 }, material = material.matte { color = srgb("#c9bfae") } },
}
local function add(name, x, z)
  objects[#objects + 1] = panel(x, z, modes[name][1], modes[name][2])
  objects[#objects + 1] = object {
    shape = mesh.plane { size = side + 0.01 }, position = { x, -0.002, z }, material = paper,
  }
end
local extent = side + 2 * gap
if mode == "all" then
  local step = side + gap
  for i, name in ipairs(order) do
    add(name, ((i - 1) % 2 - 0.5) * step, (math.floor((i - 1) / 2) - 0.5) * step)
  end
  extent = 2 * side + 3 * gap
else
  add(mode, 0, 0)
end

return scene {
  film = { width = 960, height = 960, samples = 32 },
  camera = camera.perspective { from = { 0, 8, 0 }, up = { 0, 0, -1 }, fov = 2 * math.deg(math.atan(extent / 2, 8)) },
  lights = { light.sky { strength = 0.95 } },
  objects = objects,
}
