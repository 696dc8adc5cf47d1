local toys = generator.layout {
  metod = "fill_gap",
  domain = region.rectangle { width = 2, depth = 1 },
  components = {
    { shape = mesh.banana { lenght = 0.1 }, wieght = 2 },
  },
}
return scene { objects = { toys }, camra = camera.perspective { from = {0, 1, 2} } }
