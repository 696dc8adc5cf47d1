return scene {
  objects = {
    object { shape = mesh.file { path = "parts/gltf/with_lines.gltf" } },
    object { shape = mesh.file { path = "parts/gltf/left_over.gltf" } },
    object { shape = mesh.file { path = "parts/gltf/two_scenes.gltf" } },
    object { shape = mesh.file { path = "parts/gltf/colored.gltf" } },
    object { shape = mesh.file { path = "parts/gltf/longer.glb" } },
  },
}
