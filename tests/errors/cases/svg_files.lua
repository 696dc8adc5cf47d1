local function layout(domain)
  return generator.layout { domain = domain, components = { { shape = mesh.box {} } } }
end
return scene {
  objects = {
    layout(region.svg { path = "parts/no_such.svg" }),
    layout(region.svg { path = "parts/triangle.obj" }),
    layout(region.svg { path = "parts/cut.svg" }),
    layout(region.svg { path = "parts/page.html" }),
    layout(region.svg { path = "parts/drawing.svg" }),
    layout(region.svg { path = "parts/drawing.svg", element = "dto" }),
    layout(region.svg { path = "parts/drawing.svg", element = "words" }),
    layout(region.svg { path = "parts/drawing.svg", element = "far" }),
    layout(region.svg { path = "parts/drawing.svg", element = "odd" }),
    layout(region.svg { path = "parts/drawing.svg", element = "narrow" }),
    layout(region.svg { path = "parts/drawing.svg", element = "turned" }),
    layout(region.svg { path = "parts/drawing.svg", element = "stroke" }),
    layout(region.svg { path = "parts/drawing.svg", element = "flat" }),
    layout(region.svg { path = "parts/drawing.svg", element = "box" }),
    layout(region.svg { path = "parts/drawing.svg", element = "huge" }),
    layout(region.svg { path = "parts/drawing.svg", element = "dot", size = 1, scale = 2 }),
    layout(region.svg { path = "parts/drawing.svg", element = "dot", scale = 1e6 }),
  },
}
