-- A layout as the path from script to picture makes it: files, regions, palette, instances. The
-- regions are plain and the method is naive, so that the last bit of a C library's sine, which
-- differs between systems, cannot turn a decision and with it the whole layout.
local bunny = mesh.file { path = "/usr/share/glmark2/models/bunny.obj", size = 0.16 }

return scene {
  film = { width = 160, height = 90, samples = 64 },
  camera = camera.perspective { from = { 0, 0.9, 1.1 }, at = { 0, 0, 0 }, fov = 36 },
  lights = { light.sky { strength = 0.6 }, light.sun { direction = { -1, 1.4, 0.6 }, angle = 3 } },
  objects = {
    generator.layout {
      method = "naive", cancellations = 400, seed = 5,
      domain = region.polygon { points = { { -0.7, -0.5 }, { 0.7, -0.5 }, { 0.6, 0.5 }, { -0.6, 0.5 } } },
      components = {
        { shape = bunny, region = region.rectangle { width = 0.17, depth = 0.15 }, material = material.matte { color = { 0.8, 0.75, 0.7 } } },
        { shape = mesh.star {}, region = region.rectangle { width = 0.07, depth = 0.07 }, material = material.plastic { palette = { { color = { 0.7, 0.1, 0.1 } }, { color = { 0.1, 0.2, 0.7 } } } } },
        { shape = mesh.banana {}, region = region.rectangle { width = 0.19, depth = 0.09 }, material = material.plastic { color = { 0.8, 0.6, 0.1 } } },
      },
      scale = { 0.8, 1.2 },
    },
    object { shape = mesh.plane { size = 6 }, material = material.matte { color = { 0.35, 0.3, 0.25 } } },
  },
}
