local line = { { 0, 0, 0 }, { 0, 1, 0 } }
return scene {
  objects = {
    object { shape = curve.polyline {} },
    object { shape = curve.spline { points = line, strands = { { points = line } } } },
    object { shape = curve.spline { strands = { { radius = 1 } } } },
    object { shape = curve.polyline { points = { { 0, 0, 0 } } } },
    object { shape = curve.polyline { points = { { 0, 0, 0 }, { 0, 1 } } } },
    object { shape = curve.polyline { points = { { 0, 0, 0 }, { 0, 0, 0 } } } },
    object { shape = curve.polyline { points = line, radius = 0 } },
    object { shape = curve.polyline { points = line, radius = { 1, 1, 1 } } },
    object { shape = curve.polyline { points = line, radius = { 1, -1 } } },
    object { shape = curve.polyline { points = line, radius = "thin" } },
    object { shape = curve.file { path = "parts/triangle.obj" } },
    object { shape = curve.file { path = "parts/missing.obj" } },
    object { shape = curve.file { path = "parts/picture.bmp" } },
    object { shape = curve.file { path = "parts/broken.json" } },
    object { shape = curve.file { path = "parts/strand.json" } },
    object { shape = curve.polyline { points = line }, material = "file" },
    generator.layout { components = { { shape = curve.polyline { points = line } } } },
  },
}
