-- Dropped rocks from sizes to picture: shapes, contact, lichen above and water below. Few and large
-- ones, so that a picture of this size shows how each lies.
return scene {
  film = { width = 160, height = 90, samples = 64, clamp = 4 },
  camera = camera.perspective { from = { 0, 1.1, 1.9 }, at = { 0, 0.03, 0.05 }, fov = 36 },
  lights = { light.sky { strength = 0.6 }, light.sun { direction = { -1, 1.0, 0.6 }, angle = 4 } },
  objects = {
    generator.rocks {
      domain = region.rectangle { width = 1.8, depth = 1.4 }, smallest = 0.12, largest = 0.6, cover = 0.7, wear = 0.4, triangles = 1280,
      material = material.plastic {
        color = procedural.weathered { base = procedural.granite { preset = "bianco_sardo", size = 0.05 }, lichen = 0.4, lichen_size = 0.12, wet_below = 0.05 },
      },
      ground_material = material.matte { color = { 0.3, 0.26, 0.2 } }, seed = 3,
    },
  },
}
