return scene {
  film = { filter = "gausian" },
  objects = {
    object { shape = mesh.box {}, material = material.metal { preset = "unobtainium" } },
  },
}
