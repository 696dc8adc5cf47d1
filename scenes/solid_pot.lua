-- Figure 14 of Okada et al. (1987): a pot, turned from a spline.
local solid = include("parts/solid.lua")

local function pot(material, x)
  return object {
    shape = mesh.lathe { steps = 16, segments = 256 }, material = material, position = { x, 0, 0 },
  }
end

return scene {
  film = { width = 1280, height = 720, samples = 64, clamp = 1 },
  camera = camera.perspective { from = { 0.0, 0.36, 0.75 }, at = { 0, 0.082, 0 }, fov = 16 },
  lights = solid.lights(0.14),
  objects = solid.studio {
    pot(solid.marble { origin = solid.corner }, -0.085),
    pot(solid.wood { origin = solid.corner }, 0.085),
  },
}
