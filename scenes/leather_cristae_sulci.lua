-- The parts of a leather, after figure 16 of Sakurai & Miyata 2014: cristae alone, sulci at the same
-- places alone, and both with their fine detail.
-- `scree height scenes/leather_cristae_sulci.lua -o map.exr --index 1` writes the first map and a picture of it.
local seed = arg("seed", 4)
local preset = arg("preset", "coarse_grain")

local hide = material.plastic { color = srgb("#6b4128"), roughness = 0.42, ior = 1.47 }
local objects = {
  object { shape = mesh.plane { size = 8 }, material = material.matte { color = { 0.03, 0.03, 0.032 } } },
}
for i, parts in ipairs { "cristae", "sulci", "both" } do
  objects[#objects + 1] = generator.leather {
    preset = preset, parts = parts, size = 0.05, resolution = 1024, seed = seed,
    thickness = 0.002, triangles = 1500000, material = hide, position = { (i - 2) * 0.056, 0, 0 },
  }
end

return scene {
  film = { width = 1440, height = 540, samples = 48, clamp = 8 },
  camera = camera.perspective { from = { 0, 0.3, 0.055 }, at = { 0, 0, 0.0005 }, fov = 12 },
  lights = {
    light.area {
      position = { -0.42, 0.16, -0.16 }, at = { 0, 0, 0 }, size = { 0.2, 0.2 },
      color = { 1.0, 0.95, 0.88 }, strength = 26,
    },
    light.sky { color = { 0.1, 0.105, 0.115 } },
  },
  objects = objects,
}
