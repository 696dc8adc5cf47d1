-- Paving of all sizes without a gap: one power diagram of prescribed areas.
local rocks = include("parts/rocks.lua")

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 64), clamp = 6 },
  camera = camera.perspective { from = { 0.05, 1.05, 1.35 }, at = { 0, 0, 0.12 }, fov = 36 },
  lights = rocks.daylight({ -1.0, 0.6, -0.3 }),
  objects = {
    generator.rocks {
      method = "mosaic",
      domain = region.rectangle { width = 3.4, depth = 2.8 },
      sizes = { { radius = 0.18, share = 0.4 }, { radius = 0.09, share = 0.35 }, { radius = 0.04, share = 0.25 } },
      joint = mm(3), wear = 0.35, axes = { 0.7, 0.45 }, burial = 0.35,
      materials = { rocks.sandstone({ 0.40, 0.37, 0.33 }), rocks.sandstone({ 0.33, 0.31, 0.29 }), rocks.sandstone({ 0.44, 0.38, 0.30 }) },
      seed = arg("seed", 1),
    },
    object { shape = mesh.plane { size = 40 }, material = rocks.earth },
  },
}
