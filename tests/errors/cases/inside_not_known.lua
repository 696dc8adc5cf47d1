return scene {
  objects = {
    object { shape = mesh.plane {}, material = material.glass {} },
    object { shape = mesh.file { path = "inside_out.obj" }, material = material.glass {} },
    object { shape = curve.spline { points = { { 0, 0, 0 }, { 0, 0.1, 0.05 } }, radius = 0.01 }, material = material.translucent {} },
  },
}
