return scene {
  film = { width = -3 },
  camera = camera.perspective { from = { 0, 1, 2 }, fov = 400 },
  objects = {
    object { shape = mesh.box {}, scale = 0 },
    object { shape = mesh.box {}, material = material.glass { distance = 5000 } },
    object { shape = mesh.box {}, material = material.plastic { roughness = 1.5 } },
  },
}
