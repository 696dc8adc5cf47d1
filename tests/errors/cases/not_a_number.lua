return scene {
  camera = camera.perspective { from = { 0, 0 / 0, 2 }, fov = 1 / 0 },
  objects = {
    object {
      shape = mesh.box {},
      scale = 0 / 0,
      position = { 0, -1 / 0, 0 },
    },
  },
}
