return scene {
  objects = {
    object { shape = mesh.file { path = "parts/gltf/skin_weights.gltf" } },
    object { shape = mesh.file { path = "parts/gltf/skin_joint.gltf" } },
    object { shape = mesh.file { path = "parts/gltf/skin_matrices.gltf" } },
    object { shape = mesh.file { path = "parts/gltf/skin_count.gltf" } },
    object { shape = mesh.file { path = "parts/gltf/instances.gltf" } },
    object { shape = mesh.file { path = "parts/gltf/skin_instances.gltf" } },
    object { shape = mesh.file { path = "parts/gltf/unnamed_texture.gltf" } },
    object { shape = mesh.file { path = "parts/gltf/cut.glb" } },
    object { shape = mesh.file { path = "parts/gltf/begins.glb" } },
    object { shape = mesh.file { path = "parts/gltf/version_1.glb" } },
    object { shape = mesh.file { path = "parts/gltf/chunk_kind.glb" } },
    object { shape = mesh.file { path = "parts/gltf/chunk_length.glb" } },
    object { shape = mesh.file { path = "parts/gltf/chunk_short.glb" } },
  },
}
