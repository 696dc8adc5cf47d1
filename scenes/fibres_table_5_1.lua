-- Ten single fibres, a to j of table 5.1 (Sakurai 2013, figure 5.1).
local rows = {
  { 0, 0, 0, 0 }, { 3.6, 3.6, 0, 0 }, { 7.2, 7.2, 0, 0 }, { 3.6, 3.6, 3.6, 3.6 }, { 3.6, 3.6, 7.2, 7.2 },
  { 3.6, 3.6, 10.8, 10.8 }, { -3.6, 3.6, 0, 0 }, { -7.2, 7.2, 0, 0 }, { -3.6, 7.2, 0, 0 }, { -3.6, 18, 21, 39.6 },
}
local objects = { object { shape = mesh.plane { size = 4 }, position = { 0, -0.1, 0 }, material = material.matte { color = { 0.62, 0.62, 0.6 } } } }
for i, row in ipairs(rows) do
  objects[#objects + 1] = generator.fibres {
    target = mesh.sphere { radius = 0.05 }, position = { ((i - 1) % 5 - 2) * 0.12, 0, (i > 5 and 0.12 or 0) - 0.06 },
    count = 1, length = 0.1, radius = mm(1.1), theta = { row[1], row[2] }, phi = { row[3], row[4] }, adjustment = "none",
    contact = false, seed = i, material = material.matte { color = srgb("#8a3b2e") },
  }
end
return scene {
  film = { width = 1280, height = 720, samples = 64 },
  camera = camera.perspective { from = { 0, 0.8, 0.25 }, at = { 0, 0, 0 }, fov = 27.5 },
  lights = { light.sky { strength = 0.35 }, light.sun { direction = { -1, 1.6, 0.6 }, angle = 2, strength = 1.8 } },
  objects = objects,
}
