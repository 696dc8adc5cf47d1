return scene {
  objects = {
    object { shape = mesh.file { path = "parts/meshes/decorated.ply" } },
    object { shape = mesh.file { path = "parts/meshes/decorated.obj" } },
    object { shape = mesh.file { path = "parts/meshes/no_end.stl" } },
  },
}
