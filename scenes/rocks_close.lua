-- One rock that fills the frame.
local rocks = include("parts/rocks.lua")

local granite = rocks.granite_texture("bianco_sardo")

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 96), clamp = 6 },
  camera = camera.perspective { from = { 0.12, 0.62, 1.05 }, at = { 0, 0.14, 0 }, fov = 31 },
  lights = rocks.daylight({ -1.0, 0.7, 0.55 }),
  objects = {
    object { shape = mesh.plane { size = 40 }, material = rocks.sand },
    object { shape = mesh.rock { size = 0.8, triangles = 81920, cracks = 1, seed = arg("seed", 3) }, material = rocks.old(granite, 0.35), position = { 0, -0.03, 0 } },
    generator.rocks {
      domain = region.rectangle { width = 6, depth = 5 }, smallest = 0.008, largest = 0.06, cover = 0.12,
      material = material.matte { color = granite }, burial = 0.3,
    },
  },
}
