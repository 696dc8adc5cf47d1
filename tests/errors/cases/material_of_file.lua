return scene {
  objects = {
    object { shape = mesh.plane {}, material = "file" },
    object { shape = mesh.file { path = "parts/triangle.obj" }, material = "file" },
    object { shape = mesh.file { path = "parts/gltf/no_picture.gltf" }, material = "file" },
    object { shape = mesh.file { path = "parts/gltf/no_source.gltf" }, material = "file" },
    object { shape = mesh.file { path = "parts/gltf/bad_picture.gltf" }, material = "file" },
    object { shape = mesh.file { path = "parts/meshes/library_missing.obj" }, material = "file" },
    object { shape = mesh.file { path = "parts/meshes/library_none.obj" }, material = "file" },
    object { shape = mesh.plane {}, material = "files" },
  },
}
