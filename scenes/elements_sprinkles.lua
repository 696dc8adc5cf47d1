-- A doughnut with sprinkles: elements that stand on a surface, here lying flat on it at any turn.
-- Every color is a class of its own, evenly spread by itself and all together.
local colors = { "#e84a6f", "#f7c948", "#38a3d6", "#6cbf57", "#f4f0e6", "#8d5bb8" }

local function sprinkles(surface, seed)
  local components = {}
  for i, color in ipairs(colors) do
    components[i] = {
      shape = mesh.rice { length = mm(5.5), width = mm(1.6) }, margin = mm(0.1), height = mm(-0.35),
      material = material.plastic { color = srgb(color), roughness = 0.25 },
    }
  end
  return generator.elements { surface = surface, components = components, seed = seed }
end

local objects = {}
local seed = arg("seed", 1)
local ring = mesh.torus { radius = mm(27), tube = mm(16), segments = 160 }
objects[#objects + 1] = object { shape = ring, material = material.plastic { color = srgb("#ee8fa9"), roughness = 0.2 } }
objects[#objects + 1] = sprinkles(ring, seed)
objects[#objects + 1] = object { shape = mesh.plane { size = 2 }, material = material.matte { color = srgb("#e9dfd0") } }

return scene {
  film = { width = 1280, height = 720, samples = 64, clamp = 6 },
  camera = camera.perspective { from = { 0.02, 0.13, 0.15 }, at = { 0, 0.012, 0.002 }, fov = 30 },
  lights = {
    light.sky { color = { 0.92, 0.96, 1.0 }, strength = 0.5 },
    light.sun { direction = { -1, 1.3, 0.3 }, angle = 8, color = { 1, 0.94, 0.86 }, strength = 2 },
  },
  objects = objects,
}
