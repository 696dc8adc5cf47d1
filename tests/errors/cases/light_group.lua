return scene {
  lights = { light.sky { group = "key.left" }, light.sun { group = "" } },
  objects = { object { shape = mesh.sphere {} } },
}
