return scene {
  film = { width = "big", samples = 2.5, filter = 3 },
  camera = camera.perspective {
    from = { 0, 1 },
    at = 7,
    fov = "wide",
    up = { 0, "y", 0 },
  },
  lights = light.sky {},
  objects = { object { shape = mesh.box {}, position = true, scale = { 1, 2 },
                       material = material.matte { color = "red" } } },
}
