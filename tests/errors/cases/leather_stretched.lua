return scene {
  objects = {
    generator.leather { resolution = 16, triangles = 4000,
                        shape = mesh.box { width = 0.2, height = 0.05, depth = 0.02 } },
    generator.leather { resolution = 16, triangles = 4000,
                        shape = mesh.box { width = 0.2, height = 0.05, depth = 0.02, uvs = "even" } },
    generator.leather { resolution = 16, triangles = 100, shape = mesh.plane { size = 0.02 } },
    generator.leather { resolution = 16, triangles = 100,
                        shape = mesh.file { path = "parts/meshes/no_uv_area.obj" } },
  },
}
