-- A turned bowl on a table of planks, and the rest of the block that it was turned from.
local function wood(settings, roughness)
  return material.plastic { color = procedural.wood(settings), roughness = roughness or 0.35 }
end

local objects = {}
local function add(shape, material, position, rotation)
  objects[#objects + 1] = object { shape = shape, material = material, position = position, rotation = rotation }
end

-- Cut with its foot to the pith: years show as ovals in its hollow, end grain to the left and right.
local bowl_wood = wood({
  preset = "ash", ring_thickness = 0.0046, late = srgb("#9d7245"), turbulence = 2.6, axis = { 1, 0, 0 }, origin = { 0, -0.035, 0.012 }, seed = 2,
}, 0.3)
add(mesh.lathe {
  steps = 12, segments = 256,
  profile = {
    { 0, 0.006 }, { 0.05, 0.006 }, { 0.05, 0.006 }, { 0.053, 0 }, { 0.053, 0 }, { 0.062, 0 }, { 0.062, 0 }, { 0.066, 0.006 },
    { 0.105, 0.024 }, { 0.137, 0.06 }, { 0.147, 0.098 }, { 0.147, 0.104 }, { 0.143, 0.106 }, { 0.138, 0.101 },
    { 0.127, 0.063 }, { 0.098, 0.034 }, { 0.05, 0.019 }, { 0, 0.016 },
  },
}, bowl_wood, { 0, 0, 0 }, { 0, 30, 0 })

add(mesh.box { width = 0.11, height = 0.08, depth = 0.1, rounding = 0.03 }, bowl_wood, { 0.265, 0, -0.075 }, { 0, -63, 0 })

local plank_wood = wood({ preset = "walnut", axis = { 1, 0, 0 }, vary = true })
local width = 0.17
for i = -4, 4 do
  add(mesh.box { width = 2.4, height = 0.035, depth = width - 0.0012, rounding = 0.06 }, plank_wood, { 0.13 * (i % 3), -0.035, i * width })
end

add(mesh.box { width = 6, height = 2, depth = 0.1, rounding = 0 }, material.matte { color = srgb("#b5ab9a") }, { 0, -0.5, -1.3 }) -- the wall

return scene {
  film = { width = 1280, height = 720, samples = 128, clamp = 3 },
  camera = camera.perspective { from = { 0.06, 0.4, 0.8 }, at = { 0.062, 0.032, -0.02 }, fov = 25.5, aperture = 0.008, focus = 0.8 },
  lights = {
    light.area { position = { -1.3, 0.85, -0.25 }, at = { 0, 0.05, 0 }, size = { 0.9, 0.9 }, color = { 1.0, 0.95, 0.88 }, strength = 17 },
    light.area { position = { 1.3, 0.9, 0.7 }, at = { 0, 0.05, 0 }, size = { 0.8, 0.8 }, color = { 0.9, 0.95, 1.0 }, strength = 4.5 },
    light.sky { color = { 0.9, 0.95, 1.0 }, strength = 0.32 },
  },
  objects = objects,
}
