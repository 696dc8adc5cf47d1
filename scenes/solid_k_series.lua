-- Figure 12 of Okada et al. (1987): how far the fractal pushes the layers, k. Marble from 0 to 30 by
-- 2, or with --set material=wood wood from 0 to 6 by 0.4.
local solid = include("parts/solid.lua")
local edge = solid.edge
local material_name = arg("material", "marble")
assert(material_name == "marble" or material_name == "wood", "material is marble or wood")

local step = material_name == "marble" and 2 or 0.4
local cube = mesh.box { width = edge, rounding = 0 }
local ink = material.matte { color = { 0.03, 0.03, 0.03 } }
local pitch_x, pitch_z = 1.72 * edge, 2.95 * edge
local turn = -35

local objects = {}
for row = 0, 3 do
  for column = 0, 3 do
    local k = (4 * row + column) * step
    local x, z = (column - 1.5) * pitch_x, (row - 1.5) * pitch_z
    objects[#objects + 1] = object {
      shape = cube, material = solid[material_name] { turbulence = k, origin = solid.corner },
      position = { x, 0, z }, rotation = { 0, turn, 0 },
    }
    objects[#objects + 1] = object {
      shape = mesh.text {
        text = string.format(step == 2 and "%d" or "%.1f", k), size = 0.19 * edge, height = 0.02 * edge, pose = "lying",
      },
      material = ink, position = { x, 0, z + 0.95 * edge },
    }
  end
end

return scene {
  film = { width = 900, height = 1024, samples = 64, clamp = 1 },
  camera = camera.perspective { from = { 0, 4.6, 4.6 }, at = { 0, 0.03, 0.02 }, fov = 7.5 },
  lights = solid.lights(4 * edge),
  objects = solid.studio(objects),
}
