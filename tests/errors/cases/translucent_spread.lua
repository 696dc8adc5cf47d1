return scene {
  camera = camera.perspective { from = { 0, 1, 2 } },
  objects = {
    object { shape = mesh.box {}, material = material.translucent { spread = { 1, 0.5, 0 } } },
    object { shape = mesh.box {}, material = material.translucent { spread = { 2, 0.5, 0.2 } } },
  },
}
