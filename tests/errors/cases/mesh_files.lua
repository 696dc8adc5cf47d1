return scene {
  objects = {
    object { shape = mesh.file { path = "parts/triangle.obj", closed = true } },
    object { shape = mesh.file { path = "parts/nan.obj" } },
    object { shape = mesh.file { path = "parts/triangel.obj" } },
    object { shape = mesh.file { path = "parts/picture.bmp" } },
    object { shape = mesh.file { path = "parts" } },
    object { shape = mesh.file { path = "" } },
  },
}
