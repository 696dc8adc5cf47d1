local function layout(domain)
  return generator.layout { domain = domain, components = { { shape = mesh.box {} } } }
end
return scene {
  objects = {
    layout(region.path { d = "" }),
    layout(region.path { d = "0 0 L1 1" }),
    layout(region.path { d = "M0 0 L1" }),
    layout(region.path { d = "M0 0 L1 nan" }),
    layout(region.path { d = "M0 0 K1 1" }),
    layout(region.path { d = "M0 0 A1 1 0 2 1 3 3" }),
    layout(region.path { d = "M0 0 L5e9 1" }),
    layout(region.path { d = "M0 0 L1 1 Z" }),
    layout(region.path { d = "M0 0 H1 V1 Z", fill_rule = "odd" }),
    layout(region.path { d = "M0 0 H1 V1 Z", tolerance = 0 }),
    layout(region.path {}),
  },
}
