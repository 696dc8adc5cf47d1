-- A closed room whose walls show a picture of marble, lit by an area light below the ceiling.
local marble = material.matte { color = procedural.image { path = arg("marble", "marble.png") } }
local plaster = material.matte { color = { 0.75, 0.73, 0.7 } }
local steel = material.metal { preset = "iron", roughness = 0.35 }

local function wall(material, width, depth, position, rotation)
  return object { shape = mesh.plane { size = width, depth = depth }, material = material, position = position, rotation = rotation }
end

return scene {
  film = { width = 320, height = 180, depth = 10, filter = "box", radius = 0.5 },
  camera = camera.perspective { from = { 0.3, 1.4, 1.95 }, at = { -0.1, 1.05, -1 }, fov = 55 },
  lights = { light.area { position = { 0, 2.55, 0 }, at = { 0, 0, 0 }, size = { 1, 1 }, strength = 8 } },
  objects = {
    wall(marble, 4, 4, { 0, 0, 0 }, { 0, 0, 0 }),
    wall(plaster, 4, 4, { 0, 2.6, 0 }, { 180, 0, 0 }),
    wall(marble, 4, 2.6, { 0, 1.3, -2 }, { 90, 0, 0 }),
    wall(marble, 4, 2.6, { 0, 1.3, 2 }, { -90, 0, 0 }),
    wall(marble, 2.6, 4, { -2, 1.3, 0 }, { 0, 0, -90 }),
    wall(marble, 2.6, 4, { 2, 1.3, 0 }, { 0, 0, 90 }),
    object { shape = mesh.box { width = 0.7 }, material = marble, position = { -0.6, 0, -0.6 }, rotation = { 0, 25, 0 } },
    object { shape = mesh.sphere { radius = 0.3, segments = 128 }, material = plaster, position = { -0.6, 0.7, -0.6 } },
    object { shape = mesh.torus { radius = 0.35, tube = 0.13 }, material = steel, position = { 0.6, 0, -0.2 } },
  },
}
