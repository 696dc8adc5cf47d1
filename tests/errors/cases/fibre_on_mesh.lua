return scene {
  objects = {
    object { shape = mesh.sphere {}, material = material.fibre { preset = "wool" } },
    object { shape = mesh.sphere {}, material = material.fibre { color = 0.5, absorption = 1 } },
    object { shape = mesh.sphere {}, material = material.fibre { absorption = { 0, -1, 0 } } },
    object { shape = mesh.sphere {}, material = material.fibre { palette = { { 0.5, 2, 0 } } } },
    object { shape = mesh.sphere {}, material = material.fibre { beta_m = 0.01, eta = 3, tilt = 20 } },
  },
}
