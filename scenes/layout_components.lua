-- Each of three concave components alone, as in figures 6 and 13 (a) to (c) of Sakurai & Miyata
-- (2014): --set which=e1, e2 or e3, --set method=naive, fill_gap or saturated.
local tray = include("parts/tray.lua")
local component = assert(tray.shapes[arg("which", "e1")], "which: e1, e2 or e3")

local objects = tray.objects(tray.width, tray.depth)
objects[#objects + 1] = generator.layout {
  method = arg("method", "fill_gap"),
  domain = tray.domain,
  components = { component },
  seed = arg("seed", 1),
}

return scene {
  film = { width = 1280, height = 720, samples = 64, clamp = 8 },
  camera = tray.camera, lights = tray.lights, objects = objects,
}
