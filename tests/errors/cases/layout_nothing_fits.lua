local function big(method)
  return generator.layout {
    method = method,
    domain = region.circle { radius = 0.5 },
    components = { { shape = region.path { d = "M0 0 L1 0 L0.5 0.86 Z" } } },
  }
end
return scene { objects = { big("naive"), big("saturated") } }
