local function sky(path) return light.sky { image = "parts/" .. path } end
return scene {
  lights = { sky("tall.exr"), sky("blinding.exr"), sky("squares.exr") },
  objects = { object { shape = mesh.box {} } },
}
