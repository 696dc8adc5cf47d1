-- Four leathers, each over a ball and as a flat swatch, in a low light from the left that shows
-- their relief: fine calf, coarse buffalo grain, reptile, and pebbled as on a basketball.
local seed = arg("seed", 2)
local resolution = arg("resolution", 1536)

local eye, target = { 0, 0.2, 0.41 }, { 0, 0.011, 0.0145 }
local radius, edge = 0.022, 0.044

local leathers = {
  { preset = "fine_calf", color = srgb("#6f3d21"), roughness = 0.36, turn = 7 },
  { preset = "coarse_grain", color = srgb("#4c2b1c"), roughness = 0.42, turn = -5 },
  { preset = "reptile", color = srgb("#30372a"), roughness = 0.3, turn = 4 },
  { preset = "pebbled", color = srgb("#7a3c1f"), roughness = 0.46, turn = -8 },
}

local objects = {
  object {
    shape = mesh.plane { size = 8 },
    material = material.matte { color = { 0.036, 0.0355, 0.036 } },
  },
}

for i, leather in ipairs(leathers) do
  local x = (i - 2.5) * 0.0535
  local surface = material.plastic { color = leather.color, roughness = leather.roughness, ior = 1.47 }
  objects[#objects + 1] = generator.leather {
    preset = leather.preset, size = edge, resolution = resolution, seed = seed,
    shape = mesh.sphere { radius = radius }, facing = { eye[1] - x, eye[2] - radius, eye[3] + 0.014 },
    triangles = 1600000, material = surface, position = { x, 0, -0.014 },
  }
  objects[#objects + 1] = generator.leather {
    preset = leather.preset, size = edge, resolution = resolution, seed = seed + 10,
    thickness = 0.0016, triangles = 1200000, material = surface,
    position = { 0.96 * x, 0.0035, 0.044 }, rotation = { 9, leather.turn, 0 },
  }
end

return scene {
  film = { width = 1280, height = 720, samples = 48, clamp = 8 },
  camera = camera.perspective { from = eye, at = target, fov = 16.2 },
  lights = {
    -- key: large and soft, low on the left
    light.area {
      position = { -0.5, 0.27, 0.12 }, at = { 0, 0.01, 0.02 }, size = { 0.3, 0.3 },
      color = { 1.0, 0.93, 0.84 }, strength = 26,
    },
    -- rim from behind on the right
    light.area {
      position = { 0.45, 0.3, -0.4 }, at = { 0, 0.02, 0 }, size = { 0.3, 0.2 },
      color = { 0.78, 0.88, 1.0 }, strength = 8,
    },
    light.sky { color = { 0.12, 0.125, 0.135 } },
  },
  objects = objects,
}
