return scene {
  objects = {
    generator.leather { resolution = 16, triangles = 4000,
                        shape = mesh.box { width = 0.2, height = 0.05, depth = 0.02 } },
    generator.leather { resolution = 16, triangles = 4000,
                        shape = mesh.box { width = 0.2, height = 0.05, depth = 0.02, uvs = "even" } },
    -- Boxes on both sides of the bound, with both kinds of UVs.
    generator.leather { resolution = 16, triangles = 4000, shape = mesh.box { width = 0.1, height = 0.09, depth = 0.09 } },
    generator.leather { resolution = 16, triangles = 4000, shape = mesh.box { width = 0.2, height = 0.1, depth = 0.1 } },
    generator.leather { resolution = 16, triangles = 4000, shape = mesh.box { width = 0.2, height = 0.1, depth = 0.1, rounding = 0.3 } },
    generator.leather { resolution = 16, triangles = 4000, shape = mesh.box { width = 0.1, rounding = 0.9, uvs = "even" } },
    generator.leather { resolution = 16, triangles = 100, shape = mesh.plane { size = 0.02 } },
    generator.leather { resolution = 16, triangles = 100,
                        shape = mesh.file { path = "parts/meshes/no_uv_area.obj" } },
  },
}
