local function file(fields)
  fields.path = "parts/meshes/millimetres.obj"
  return object { shape = mesh.file(fields) }
end
return scene {
  objects = {
    file {},
    file { centre = true },
    file { unit = "mm" },
    file { unit = "m" },
    file { size = 0.1 },
  },
}
