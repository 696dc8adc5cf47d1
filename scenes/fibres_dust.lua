-- A dust ball on a table: curled lint of all lengths, and a few longer hairs.
local pile = include("parts/pile.lua")
local lump = mesh.rock { size = 0.026, axes = { 0.85, 0.7 }, wear = 0.7, seed = 5 }
local function lint(count, length, radius, color, seed, turn)
  return generator.fibres {
    target = lump, position = { 0, 0.0002, 0 }, count = count, length = length, segments = 24, radius = radius,
    theta = { 0, turn }, phi = { 0, 40 }, contact = false, seed = seed, material = material.fibre { preset = "cotton", color = color },
  }
end

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 128) },
  camera = camera.perspective { from = { 0.01, 0.035, 0.085 }, at = { 0, 0.008, 0 }, fov = 26 },
  lights = pile.lights(0.02, 1.1),
  objects = {
    pile.table_top(0.02, srgb("#3b2a1f")),
    lint(arg("count", 1300), { 0.012, 0.04 }, mm(0.02), srgb("#9a9a9c"), 1, 14),
    lint(160, { 0.02, 0.035 }, mm(0.025), srgb("#7f93b0"), 2, 10),
    lint(25, { 0.03, 0.06 }, mm(0.035), srgb("#5a3b28"), 3, 12),
  },
}
