return scene { objects = { object { shape = mesh.file { path = "parts/meshes/no_area.obj" } } } }
