return scene {
  objects = {
    object { shape = mesh.file { path = "inside_out.obj" }, material = material.matte { color = procedural.image { path = "two_pixels.png" } } },
  },
}
