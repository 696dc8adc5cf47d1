-- A scree slope: thirty thousand fragments at their angle of repose, larger ones farther down.
local rocks = include("parts/rocks.lua")

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 64), clamp = 6 },
  camera = camera.perspective { from = { -0.8, -2.6, 7.2 }, at = { 0.2, -1.75, 1.5 }, fov = 38 },
  lights = rocks.daylight(),
  objects = {
    generator.rocks {
      preset = "scree",
      domain = region.rectangle { width = 13, depth = 16 },
      smallest = 0.06, largest = 1.0, cover = arg("cover", 1.1),
      materials = { rocks.sandstone({ 0.36, 0.33, 0.29 }), rocks.sandstone({ 0.30, 0.28, 0.26 }), rocks.sandstone({ 0.42, 0.37, 0.30 }) },
      ground_material = rocks.earth,
      measure = arg("measure", 0), seed = arg("seed", 1),
    },
  },
}
