local function object_of(path)
  return object { shape = mesh.box {},
                  material = material.matte { color = procedural.image { path = "parts/" .. path } } }
end
return scene {
  objects = {
    object_of("odd.exr"),
    object_of("apart.exr"),
    object_of("wide.exr"),
    object_of("gamma.png"),
    object_of("uncalibrated.jpg"),
  },
}
