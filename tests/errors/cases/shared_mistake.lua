-- A texture with a mistake that two materials share: one message, not a failure within.
local stone = procedural.marble { vein_hight = 1 }
return scene {
  camera = camera.perspective { from = { 0, 1, 2 }, at = { 0, 0, 0 } },
  objects = {
    object { shape = mesh.box {}, material = material.matte { color = stone } },
    object { shape = mesh.sphere {}, material = material.plastic { color = stone } },
  },
}
