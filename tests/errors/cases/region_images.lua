local function layout(domain)
  return generator.layout { domain = domain, components = { { shape = mesh.box {} } } }
end
return scene {
  objects = {
    layout(region.image { path = "parts/no_such.png" }),
    layout(region.image { path = "parts/picture.bmp" }),
    layout(region.image { path = "parts/triangle.obj", channel = "alpha" }),
    layout(region.image { path = "parts/picture.bmp", size = 1, depth = 2 }),
  },
}
