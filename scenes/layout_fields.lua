-- Fields steer a layout. koi: two shoals swim in a circle (direction), small in the middle (scale_by),
-- and are the halves of a yin and yang (classes). --set show=leaves: a whirlwind of leaves.
local motifs = include("parts/motifs.lua")
local show = arg("show", "koi")
assert(show == "koi" or show == "leaves", "show: koi or leaves")

local paint = motifs.dye

-- Which half of a yin and yang of radius 1 a point belongs to: 1 or 2.
local function yin_yang(x, z)
  local upper, lower = x * x + (z + 0.5) ^ 2, x * x + (z - 0.5) ^ 2
  if upper < 0.026 then return 2 end
  if lower < 0.026 then return 1 end
  if upper < 0.25 then return 1 end
  if lower < 0.25 then return 2 end
  return x < 0 and 1 or 2
end

local layout = {
  method = arg("method", "saturated"),
  domain = region.circle { radius = 1, segments = 192 },
  epsilon = 0.03,
  seed = arg("seed", 1),
}
local ground, pond

if show == "leaves" then
  local momiji = motifs.component("momiji", 0.13, paint("#c23b22", "#d9602c", "#e08a35", "#a82c24"), 0.002)
  local ginkgo = motifs.component("ginkgo", 0.115, paint("#e2b53c", "#d8a22e", "#b9a94c", "#e9c95e"), 0.002)
  momiji.class, ginkgo.class = 1, 2
  layout.components = { momiji, ginkgo }
  layout.direction = field.whirl { turn = 62 }
  layout.rotation = { 75, 105 }
  layout.scale_by = field.gradient { from = { 0, 0 }, to = { 1, 0 }, radial = true, low = 0.35, high = 1.25 }
  layout.classes = field.function {
    width = 2, depth = 2, resolution = 512,
    value = function(x, z) -- two arms of a spiral
      local turn = math.atan(z, x) + 3.2 * math.log(math.sqrt(x * x + z * z) + 0.02)
      return math.sin(2 * turn) > 0 and 1 or 2
    end,
  }
  ground, pond = srgb("#3a4a42"), srgb("#ece3cf")
else
  local dark = motifs.component("carp", 0.118, paint("#1f2b3d", "#2a3950", "#34455f"), 0.0015)
  local light = motifs.component("carp", 0.118, paint("#e2562f", "#ee7a3c", "#f6ecdc", "#f4e3c8", "#e9683a"), 0.0015)
  dark.class, light.class = 1, 2
  layout.components = { dark, light }
  layout.direction = field.whirl { turn = 90 }
  layout.rotation = { -14, 14 }
  layout.scale_by = field.gradient { from = { 0, 0 }, to = { 1, 0 }, radial = true, low = 0.45, high = 1.0 }
  layout.classes = field.function { width = 2, depth = 2, resolution = 512, value = yin_yang }
  ground, pond = srgb("#dfe3d8"), srgb("#8fbcb8")
end

return scene {
  film = { width = 960, height = 960, samples = 48 },
  camera = camera.perspective { from = { 0, 6, 0 }, up = { 0, 0, -1 }, fov = 21.6 },
  lights = {
    light.sky { color = { 0.96, 0.98, 1.0 }, strength = 0.62 },
    light.sun { direction = { -1, 1.1, -0.8 }, angle = 6, color = { 1, 0.95, 0.86 }, strength = 1.7 },
  },
  objects = {
    generator.layout(layout),
    object {
      shape = mesh.cylinder { radius = 1.045, height = 0.012, segments = 256 }, position = { 0, -0.012, 0 },
      material = material.matte { color = pond },
    },
    object { shape = mesh.plane { size = 6 }, position = { 0, -0.012, 0 }, material = material.matte { color = ground } },
  },
}
