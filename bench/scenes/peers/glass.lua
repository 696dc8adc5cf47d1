-- A ball of glass on a matte floor under an area light: all light below it is a caustic, which a
-- path tracer finds only by chance.
return scene {
  film = { width = 320, height = 180, depth = 10, filter = "box", radius = 0.5 },
  camera = camera.perspective { from = { 0, 0.16, 0.42 }, at = { 0, 0.045, 0 }, fov = 32 },
  lights = { light.area { position = { -0.25, 0.5, 0.05 }, at = { 0, 0, 0 }, size = { 0.25, 0.25 }, strength = 12 } },
  objects = {
    object { shape = mesh.sphere { radius = 0.05, segments = 256 }, material = material.glass { ior = 1.5 } },
    object { shape = mesh.plane { size = 4 }, material = material.matte { color = { 0.7, 0.65, 0.6 } } },
  },
}
