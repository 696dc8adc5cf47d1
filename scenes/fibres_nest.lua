-- A bird's nest: stiff twigs that run around a hollow and came to rest on each other.
local pile = include("parts/pile.lua")
local nest = include("parts/nest.lua")

-- Their heights are those at which they touch the twigs of seed 1.
local function egg(position, turn, color)
  return object {
    shape = mesh.sphere { radius = 0.016 }, scale = { 0.8, 0.8, 1.05 }, rotation = { 0, turn, 0 }, position = position,
    material = material.plastic { color = srgb(color), roughness = 0.35 },
  }
end

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 128) },
  camera = camera.perspective { from = { 0, 0.26, 0.42 }, at = { 0, 0.028, 0 }, fov = 25 },
  lights = pile.lights(0.2, 1.0),
  objects = {
    pile.table_top(0.2, srgb("#8d9178")),
    generator.fibres {
      target = nest.shape,
      count = arg("count", 900), length = { 0.08, 0.17 }, segments = 24, radius = mm(0.8), taper = 0.6, theta = { -5, 6 }, phi = { -20, 20 },
      flow = field.whirl { turn = 90 }, flow_strength = 0.25, seed = arg("seed", 1), gravity = true, floor = 0, stiffness = 1, friction = 0.8,
      material = nest.twigs,
    },
    egg({ -0.015, 0.0247, 0.004 }, 10, "#a9c4c4"), egg({ 0.014, 0.0243, -0.01 }, 70, "#9dbcbd"), egg({ 0.012, 0.0264, 0.021 }, -40, "#a3c1bf"),
  },
}
