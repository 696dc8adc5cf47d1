-- Fig. 15 of Sakurai & Miyata: rocks of three sizes with a solid texture. --set method=mosaic closes
-- the gaps; --set texture=stone.
local rocks = include("parts/rocks.lua")
local texture = arg("texture", "granite") == "granite" and rocks.granite_texture("bianco_sardo", 0.02) or rocks.sandstone_texture({ 0.40, 0.36, 0.31 }, 0.06)

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 64), clamp = 6 },
  camera = camera.perspective { from = { 0, 0.74, 0.66 }, at = { 0, 0, 0.12 }, fov = 36 },
  lights = rocks.daylight({ -1.0, 0.42, 0.1 }),
  objects = {
    object { shape = mesh.plane { size = 40 }, material = rocks.earth },
    generator.rocks {
      method = arg("method", "paper"), domain = region.rectangle { width = 1.9, depth = 1.3 },
      sizes = {
        { radius = 0.09, share = 0.2, widening = { 0, 0.006, 0.006 }, height = { 0.014, 0.014, 0.009 } },
        { radius = 0.03, share = 0.24, widening = { 0, 0.006, 0.002 }, height = { 0.005, 0.005, 0.003 } },
        { radius = 0.01, share = 0.56, widening = { 0.002, 0.002, 0.002 }, height = { 0.002, 0.002, 0.001 } },
      },
      material = material.matte { color = texture }, seed = arg("seed", 1),
    },
  },
}
