return scene {
  camera = camera.perspective {},
  objects = {
    object {},
    generator.layout {},
    object { shape = mesh.file {} },
  },
}
