-- Grains of rice, all of one size, on a bunny of any size: one pass.
return scene {
  camera = camera.perspective { from = { 0.1, 0.2, 0.5 }, at = { 0, 0.07, 0 }, fov = 25 },
  lights = { light.sky {} },
  objects = {
    generator.pile {
      target = mesh.file { path = "/usr/share/glmark2/models/bunny.obj", size = arg("size", 0.15) },
      components = { { shape = mesh.rice { length = mm(6.2), width = mm(2.5) }, material = material.matte {} } },
      cover = arg("cover", 0), overlap = arg("overlap", 0), measure = arg("measure", 0), seed = arg("seed", 1),
      method = arg("method", "insertion"),
    },
  },
}
