-- A ball that fills the picture: plain, of marble or of wood.
local kind = arg("material", "plain")
local color = { 0.6, 0.6, 0.6 }
if kind == "marble" then color = procedural.marble { preset = "banded", size = 0.5 } end
if kind == "wood" then color = procedural.wood { preset = "oak", size = 0.5 } end

return scene {
  film = { width = 256, height = 256, samples = 32 },
  camera = camera.perspective { from = { 0, 0.5, 1.2 }, at = { 0, 0.5, 0 }, fov = 32 },
  lights = {
    light.area { position = { -3, 4, 3 }, at = { 0, 0.5, 0 }, size = { 2, 2 }, strength = 14 },
    light.sky { strength = 0.5 },
  },
  objects = {
    object { shape = mesh.sphere { radius = 0.5 }, material = material.plastic { color = color, roughness = 0.2 } },
  },
}
