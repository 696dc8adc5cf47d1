-- A pile from components to picture: sites, insertion, settling, palettes. Few and large components,
-- so that a picture of this size shows how each lies.
return scene {
  film = { width = 160, height = 90, samples = 64, clamp = 4 },
  camera = camera.perspective { from = { 0, 0.2, 0.36 }, at = { 0, 0.056, 0 }, fov = 30 },
  lights = { light.sky { strength = 0.6 }, light.sun { direction = { -1, 1.4, 0.8 }, angle = 4 } },
  objects = {
    generator.pile {
      target = mesh.sphere { radius = 0.055 },
      components = {
        { shape = mesh.box { width = 0.016, rounding = 0.1 }, material = material.plastic { color = { 0.1, 0.3, 0.55 } } },
        { shape = mesh.torus { radius = 0.011, tube = 0.004 }, material = material.plastic { color = { 0.7, 0.15, 0.08 } } },
        { shape = mesh.sphere { radius = 0.009 }, material = material.plastic { color = { 0.8, 0.6, 0.1 } } },
      },
      rotation = { 360, 360, 360 }, seed = 4,
    },
    object { shape = mesh.plane { size = 4 }, material = material.matte { color = { 0.5, 0.48, 0.44 } } },
  },
}
