-- The four modes of figure 2 of Kita & Miyata (2012), 2000 to 3000 elements each on a square of 1 m
-- that tiles, for the spectra of docs/spectra.md:
--   scree analyse scenes/elements_spectra.lua --seeds 10 -o spectra.json
local modes = {
  { whirl = false, { 1, 1 } },
  { whirl = true, { 1.6, 0.625 } },
  { whirl = false, { 1.6, 1.6 }, { 1, 1 }, { 2.5, 2.5 }, { 1, 1 } },
  { whirl = true, { 2.4, 1.2 }, { 1.5, 0.5 }, { 1, 1 } },
}
local distance = 0.02 -- [m]; centres of one class keep this far apart, times its axes
local drawn = 0.16 -- size of what is drawn relative to that: small enough for classes to stay apart
local step = 1.06

local objects = {}
for i, mode in ipairs(modes) do
  local x, z = ((i - 1) % 2 - 0.5) * step, (math.floor((i - 1) / 2) - 0.5) * step
  local components = {}
  for k, axes in ipairs(mode) do
    local a, b = axes[1] * distance * drawn, axes[2] * distance * drawn
    components[k] = {
      shape = region.path {
        d = string.format("M %f 0 A %f %f 0 0 1 %f 0 A %f %f 0 0 1 %f 0 Z", -a, a, b, a, a, b, -a),
      },
      length = axes[1] * distance,
      width = axes[2] * distance,
    }
  end
  objects[i] = generator.elements {
    domain = region.path {
      d = string.format("M %f %f h 1 v 1 h -1 Z", x - 0.5, z - 0.5),
      centred = false,
    },
    torus = true,
    components = components,
    direction = mode.whirl and field.whirl { centre = { x, z }, turn = 70 } or nil,
    relax = arg("relax", 0),
    seed = arg("seed", 1),
  }
end

return scene {
  film = { width = 960, height = 960, samples = 16 },
  camera = camera.perspective { from = { 0, 8, 0 }, up = { 0, 0, -1 }, fov = 2 * math.deg(math.atan(step + 0.06, 8)) },
  lights = { light.sky {} },
  objects = objects,
}
