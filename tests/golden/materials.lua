-- Every material, light and a procedural in one small picture.
local function ball(x, material)
  return object { shape = mesh.sphere { radius = 0.16 }, material = material, position = { x, 0, 0 } }
end

return scene {
  film = { width = 160, height = 90, samples = 64 },
  camera = camera.perspective { from = { 0, 0.7, 1.9 }, at = { 0, 0.12, 0 }, fov = 34, aperture = 0.02 },
  lights = {
    light.sky { zenith = { 0.3, 0.5, 0.9 }, horizon = { 0.8, 0.9, 1 }, ground = { 0.2, 0.2, 0.2 } },
    light.sun { direction = { 1, 2, 1.5 }, angle = 4 },
    light.area { position = { -1.2, 1, 0.6 }, at = { 0, 0, 0 }, size = { 0.5, 0.5 }, strength = 6 },
  },
  objects = {
    ball(-0.72, material.matte { color = { 0.7, 0.3, 0.2 } }),
    ball(-0.36, material.plastic { color = { 0.1, 0.3, 0.7 }, roughness = 0.2 }),
    ball(0, material.metal { preset = "gold", roughness = 0.3 }),
    ball(0.36, material.glass {}),
    ball(0.72, material.glass { roughness = 0.4 }),
    object {
      shape = mesh.sphere { radius = 0.1 }, position = { 0.16, 0.1, 0.4 },
      material = material.translucent { color = { 0.9, 0.7, 0.5 }, distance = 0.03, spread = { 1, 0.5, 0.25 } },
    },
    object {
      shape = mesh.plane { size = 8 },
      material = material.matte { color = procedural.checker { size = 0.25 } },
    },
  },
}
