-- Two kinds of trees at a fifth to their full size, as in figure 13 (d) of Sakurai & Miyata (2014):
-- the outlines of the crowns are kept apart. --set method=naive, fill_gap or saturated.
local broadleaf = material.matte {
  palette = { srgb("#7f9a3c"), srgb("#9aa83f"), srgb("#c9a23a"), srgb("#c9772e"), srgb("#b4552b"), srgb("#6f8f3e") },
}
local conifer = material.matte { palette = { srgb("#2f5d47"), srgb("#3b6b4a"), srgb("#2a5450"), srgb("#4b7750") } }

local forest = generator.layout {
  method = arg("method", "fill_gap"),
  domain = region.circle { radius = 4.4, segments = 128 },
  components = {
    { shape = mesh.tree { style = "round", height = 2.0, width = 0.68, trunk = 0.09, seed = 4 }, material = broadleaf },
    { shape = mesh.tree { style = "conifer", height = 2.6, width = 0.42, trunk = 0.08, tiers = 4 }, material = conifer },
  },
  scale = { 0.2, 1.0 },
  seed = arg("seed", 3),
}

return scene {
  film = { width = 1280, height = 720, samples = 48, clamp = 8 },
  camera = camera.perspective { from = { 0, 7.4, 12.6 }, at = { 0, 0, 0 }, fov = 28 },
  lights = {
    light.sky { zenith = { 0.38, 0.55, 0.85 }, horizon = { 0.95, 0.95, 0.95 }, ground = { 0.3, 0.3, 0.25 }, strength = 0.6 },
    light.sun { direction = { -1.4, 0.95, 0.25 }, angle = 2.5, color = { 1.0, 0.87, 0.68 }, strength = 4.2 },
  },
  objects = {
    forest,
    object { -- a round meadow
      shape = mesh.cylinder { radius = 4.8, height = 0.25, rounding = 0.4, segments = 256 }, position = { 0, -0.25, 0 },
      material = material.matte { color = srgb("#93a35a") },
    },
    object { shape = mesh.plane { size = 100 }, position = { 0, -0.25, 0 }, material = material.matte { color = srgb("#d9cdb4") } },
  },
}
