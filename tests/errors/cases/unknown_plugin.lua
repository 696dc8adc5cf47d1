return scene {
  camera = camera.perspectiv { from = { 0, 1, 2 } },
  lights = { light.sunn {} },
  objects = {
    object { shape = mesh.bananna {}, material = material.plastik {} },
    object { shape = mesh.box {}, material = material.zzzzzzzzz {} },
    object { shape = mesh.box {}, material = material.matte { color = procedural.cheker {} } },
    generator.layuot {},
  },
}
