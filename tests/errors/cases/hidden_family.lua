local light = light.sky {}
return scene {
  lights = { light, light.area {} },
  objects = { object { shape = mesh.sphere {} } },
}
