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
    -- Small in the scene, long in the scene, and a component.
    object { shape = mesh.file { path = "parts/meshes/millimetres.obj", up = "z" }, scale = 0.001 },
    object { shape = mesh.file { path = "parts/triangle.obj" }, scale = { 1, 200, 1 } },
    generator.layout { domain = region.rectangle { width = 100, depth = 100 }, max_count = 1,
                       components = { { shape = mesh.file { path = "parts/meshes/millimetres.obj", crease = 10 } } } },
  },
}
