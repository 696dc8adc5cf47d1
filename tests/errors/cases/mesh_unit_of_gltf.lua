return scene {
  objects = {
    object { shape = mesh.file { path = "parts/gltf/colored.gltf", unit = "mm" } },
    object { shape = mesh.file { path = "parts/triangle.obj", unit = "inch" } },
  },
}
