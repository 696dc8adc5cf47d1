-- A dust ball on a table: curled lint of all lengths, and the hairs and lint that fell off it.
local lump = mesh.rock { size = 0.03, axes = { 0.85, 0.62 }, wear = 0.8, seed = 5 }
local function look(color) return material.fibre { preset = "cotton", color = srgb(color) } end

-- The lump is sunk into the table by a tenth of its height, so that the ball has a foot and does not
-- stand on its lowest fibre.
local function lint(count, length, radius, color, seed, turn)
  return generator.fibres {
    target = lump, position = { 0, -0.002, 0 }, count = count, length = length, segments = 24, radius = radius,
    theta = { 0, turn }, phi = { 0, 40 }, contact = false, seed = seed, material = look(color),
  }
end

-- What lies flat on the table.
local function fallen(count, length, radius, color, seed, size)
  return generator.fibres {
    target = mesh.box { width = size, height = 0.004, depth = 0.7 * size, rounding = 0.5 }, count = count, length = length, segments = 16,
    radius = radius, floor = 0, gravity = true, theta = { 0, 12 }, phi = { 0, 40 }, seed = seed, material = look(color),
  }
end

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 128), clamp = 8 },
  camera = camera.perspective { from = { 0.006, 0.027, 0.074 }, at = { 0.002, 0.0065, 0 }, fov = 25, aperture = 0.0012, focus = 0.068 },
  lights = {
    -- A small low lamp from the left, a dim window from behind.
    light.area { position = { -0.28, 0.12, -0.02 }, at = { 0, 0.005, 0 }, size = { 0.05, 0.05 }, color = { 1.0, 0.9, 0.76 }, strength = 230 },
    light.area { position = { 0.2, 0.25, -0.35 }, at = { 0, 0.01, 0 }, size = { 0.15, 0.12 }, color = { 0.8, 0.9, 1.0 }, strength = 7 },
    light.sky { color = { 0.8, 0.88, 1.0 }, strength = 0.12 },
  },
  objects = {
    object {
      shape = mesh.box { width = 3, height = 0.03, depth = 3, rounding = 0 }, position = { 0, -0.03, 0 },
      material = material.plastic {
        color = procedural.wood { preset = "walnut", axis = { 1, 0, 0.15 }, origin = { 0, -0.02, 0.03 } }, roughness = 0.5,
      },
    },
    lint(arg("count", 1300), { 0.012, 0.04 }, mm(0.02), "#726e6b", 1, 14),
    lint(160, { 0.02, 0.045 }, mm(0.022), "#566a8c", 2, 14),
    lint(60, { 0.03, 0.06 }, mm(0.02), "#8a7f74", 5, 16),
    fallen(9, { 0.02, 0.05 }, mm(0.03), "#7a5436", 3, 0.07),
    fallen(40, { 0.003, 0.01 }, mm(0.02), "#b4b4b4", 4, 0.09),
  },
}
