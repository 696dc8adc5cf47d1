-- Figure 13 of Okada et al. (1987): a ball of which an octant is taken out. The texture has no place
-- to which it draws together, and goes on where it is cut.
local solid = include("parts/solid.lua")
local radius = solid.edge / 2

local function ball(material, x)
  return object {
    shape = mesh.cut_sphere { radius = radius, segments = 256 }, material = material,
    position = { x, 0, 0 }, rotation = { 0, 30, 0 },
  }
end

return scene {
  film = { width = 1280, height = 720, samples = 64, clamp = 1 },
  camera = camera.perspective { from = { 0, 0.3, 0.55 }, at = { 0, 0.047, 0 }, fov = 15.5 },
  lights = solid.lights(2 * radius),
  objects = solid.studio {
    ball(solid.marble { origin = solid.corner }, -0.062),
    ball(solid.wood { origin = solid.corner }, 0.062),
  },
}
