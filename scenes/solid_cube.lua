-- Figure 10 of Okada et al. (1987): a cube whose faces are those of the lattice.
local solid = include("parts/solid.lua")
local edge = solid.edge

local function cube(material, x)
  return object {
    shape = mesh.box { width = edge, rounding = 0 }, material = material, position = { x, 0, 0 }, rotation = { 0, -32, 0 },
  }
end

return scene {
  film = { width = 1280, height = 720, samples = 64, clamp = 1 },
  camera = camera.perspective { from = { 0, 0.42, 0.75 }, at = { 0, 0.044, 0 }, fov = 13.5 },
  lights = solid.lights(edge),
  objects = solid.studio {
    cube(solid.marble { origin = solid.corner }, -0.078),
    cube(solid.wood { origin = solid.corner }, 0.078),
  },
}
