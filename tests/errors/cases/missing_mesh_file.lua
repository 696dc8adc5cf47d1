return scene {
  objects = {
    object { shape = mesh.file { path = "no_such.obj" } },
  },
}
