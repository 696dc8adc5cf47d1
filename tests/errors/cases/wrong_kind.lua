local grey = material.matte {}
return scene {
  camera = light.sky {},
  lights = { material.matte {}, mesh.box {} },
  film = grey,
  objects = {
    object { shape = grey, material = mesh.box {} },
    object { shape = region.circle {} },
    mesh.box {},
    generator.layout { domain = mesh.box {}, components = { grey, 3, { shape = light.sun {} } } },
    object { shape = mesh.box {}, material = material.matte { color = mesh.box {} } },
    5,
  },
}
