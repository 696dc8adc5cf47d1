return scene {
  objects = {
    object { shape = mesh.file { path = "parts/meshes/comma.obj" } },
    object { shape = mesh.file { path = "parts/meshes/short.obj" } },
    object { shape = mesh.file { path = "parts/meshes/index.obj" } },
    object { shape = mesh.file { path = "parts/meshes/lines.obj" } },
    object { shape = mesh.file { path = "parts/meshes/surface.obj" } },
    object { shape = mesh.file { path = "parts/meshes/far.obj" } },
    object { shape = mesh.file { path = "parts/meshes/more_rows.ply" } },
    object { shape = mesh.file { path = "parts/meshes/fewer_rows.ply" } },
    object { shape = mesh.file { path = "parts/meshes/index.ply" } },
    object { shape = mesh.file { path = "parts/meshes/word.stl" } },
    object { shape = mesh.file { path = "parts/meshes/cut.stl" } },
    object { shape = mesh.file { path = "parts/meshes/more.stl" } },
  },
}
