return scene {
  objects = {
    object {
      shape = mesh.sphere {},
      material = material.matte { color = procedural.weathered { base = procedural.stone {} } },
    },
  },
}
