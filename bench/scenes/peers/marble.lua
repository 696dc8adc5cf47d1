-- The stone whose picture is on the walls of room.lua.
return scene {
  objects = {
    object {
      shape = mesh.plane { size = 3 },
      material = material.matte { color = procedural.marble { preset = "carrara", size = 0.9 } },
    },
  },
}
