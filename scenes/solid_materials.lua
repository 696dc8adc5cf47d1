-- Granite, breccia, stone, leather and bark in all their presets, on steps; from the back: bark,
-- granite, breccia, stone, leather. Leather is three times as large as life, so that its grain shows.
local rows = {
  { kind = "leather", presets = { "calf", "buffalo", "morocco", "shagreen", "pigskin", "ostrich" }, size = 0.3, roughness = 0.4,
    shape = mesh.sphere { radius = 0.052, segments = 192 } },
  { kind = "stone", presets = { "portland", "travertine_romano", "red_sandstone", "rainbow_sandstone", "welsh_slate", "jura" }, size = 0.1,
    shape = mesh.box { width = 0.105, height = 0.085, depth = 0.085, rounding = 0.04 }, roughness = 0.8, turn = 24 },
  { kind = "breccia", presets = { "breccia_oniciata", "grand_antique", "breccia_medicea", "breccia_pernice", "breccia_aurora" }, size = 0.1,
    shape = mesh.sphere { radius = 0.056, segments = 192 }, roughness = 0.1 },
  { kind = "granite", presets = { "bianco_sardo", "rosa_porrino", "baltic_brown", "nero_africa", "blue_pearl", "imperial_red" }, size = 0.1,
    shape = mesh.box { width = 0.095, rounding = 0.06 }, roughness = 0.12, turn = 32 },
  { kind = "bark", presets = { "oak", "pine", "birch", "plane", "cherry" }, size = 0.1,
    shape = mesh.cylinder { radius = 0.058, height = 0.24, rounding = 0.02, segments = 192 }, roughness = 0.8 },
}

local objects = {}
local step = { width = 0.21, height = 0.085, depth = 0.16 }
for row, list in ipairs(rows) do
  local y, z = (row - 1) * step.height, -(row - 1) * step.depth
  objects[#objects + 1] = object {
    shape = mesh.box { width = 4, height = y + 0.2, depth = step.depth, rounding = 0 },
    material = material.matte { color = { 0.22, 0.22, 0.23 } }, position = { 0, -0.2, z },
  }
  for i, preset in ipairs(list.presets) do
    objects[#objects + 1] = object {
      shape = list.shape,
      material = material.plastic { color = procedural[list.kind] { preset = preset, size = list.size, seed = 2 + i }, roughness = list.roughness },
      position = { (i - (#list.presets + 1) / 2) * step.width * (#list.presets == 5 and 1.1 or 1), y, z },
      rotation = { 0, list.turn or 0, 0 },
    }
  end
end
objects[#objects + 1] = object {
  shape = mesh.box { width = 6, height = 3, depth = 0.1, rounding = 0 }, position = { 0, -0.2, -#rows * step.depth },
  material = material.matte { color = { 0.30, 0.31, 0.33 } },
}
objects[#objects + 1] = object {
  shape = mesh.box { width = 4, height = 0.1, depth = 2, rounding = 0 }, position = { 0, -0.1, 1 + step.depth / 2 },
  material = material.matte { color = { 0.22, 0.22, 0.23 } },
}

return scene {
  film = { width = 1280, height = 720, samples = 144, clamp = 4, exposure = -0.2 },
  camera = camera.perspective { from = { 0.0, 0.82, 2.0 }, at = { 0, 0.262, -0.32 }, fov = 19.3 },
  lights = {
    light.sky { zenith = { 0.75, 0.85, 1.0 }, horizon = { 1, 1, 1 }, ground = { 0.3, 0.3, 0.3 }, strength = 0.8 },
    light.area { position = { -1.6, 1.9, 1.5 }, at = { 0, 0.2, -0.3 }, size = { 0.9, 0.9 }, color = { 1.0, 0.95, 0.88 }, strength = 17 },
  },
  objects = objects,
}
