return scene {
  lights = { light.sky { image = "parts/square.exr" } },
  objects = { object { shape = mesh.box {} } },
}
