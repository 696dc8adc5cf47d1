-- Figure 11 of Okada et al. (1987): the cube of figure 10 cut into slices. Each slab has its texture
-- where it lay in the cube.
local solid = include("parts/solid.lua")
local edge, count = solid.edge, 8
local thickness = edge / count
local slab = mesh.box { width = edge, height = edge, depth = thickness, rounding = 0 }

local objects = {}
local function slices(material_of, y, z)
  for i = 1, count do
    local front = (i - 0.5) * thickness -- from the cube's front face to the slab's middle
    objects[#objects + 1] = object {
      shape = slab,
      material = material_of { origin = { solid.corner[1], solid.corner[2], solid.corner[3] + front } },
      position = { (i - (count + 1) / 2) * 1.16 * edge, y, z }, rotation = { 0, -24, 0 },
    }
  end
end

slices(solid.marble, 0.75 * edge, -0.9 * edge)
slices(solid.wood, 0, 0)
objects[#objects + 1] = object { -- the step for the upper row
  shape = mesh.box { width = 20 * edge, height = 0.75 * edge, depth = 8 * edge, rounding = 0 },
  position = { 0, 0, -4.5 * edge }, material = material.matte { color = { 0.36, 0.36, 0.37 } },
}

return scene {
  film = { width = 1280, height = 400, samples = 64, clamp = 1 },
  camera = camera.perspective { from = { 0, 0.95, 2.3 }, at = { 0, 0.085, -0.05 }, fov = 6.95 },
  lights = solid.lights(3 * edge),
  objects = solid.studio(objects),
}
