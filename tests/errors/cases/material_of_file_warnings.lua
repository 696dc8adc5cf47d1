return scene {
  objects = {
    object { shape = mesh.file { path = "parts/gltf/decorated.gltf" }, material = "file" },
    object { shape = mesh.file { path = "parts/gltf/tinted_glass.gltf" }, material = "file" },
    object { shape = mesh.file { path = "parts/gltf/webp.gltf" }, material = "file" },
    object { shape = mesh.file { path = "parts/meshes/decorated_material.obj" }, material = "file" },
    object { shape = mesh.file { path = "parts/meshes/other_library.obj" }, material = "file" },
  },
}
