-- Three concave components together, as in figures 1 and 4 of Sakurai & Miyata (2014): poisson keeps
-- their circumscribed circles apart, naive throws darts, fill_gap seeks the gaps, and saturated goes
-- on until nothing more fits.
local method = arg("method", "fill_gap")
local tray = include("parts/tray.lua")
local e1, e2, e3 = tray.shapes.e1, tray.shapes.e2, tray.shapes.e3

if method == "poisson" then
  for _, component in ipairs { e1, e2, e3 } do
    component.region = region.circle { radius = 0.0745 } -- the largest, that of e3
  end
end

local objects = tray.objects(tray.width, tray.depth)
objects[#objects + 1] = generator.layout {
  method = method == "poisson" and "naive" or method,
  domain = tray.domain,
  components = { e1, e2, e3 },
  seed = arg("seed", 5),
}

return scene {
  film = { width = 1280, height = 720, samples = 64, clamp = 8 },
  camera = tray.camera, lights = tray.lights, objects = objects,
}
