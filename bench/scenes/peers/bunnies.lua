-- 5,000 bunnies in a block under a constant sky and an area light, all grey.
math.randomseed(7)
local bunny = mesh.file { path = "/usr/share/glmark2/models/bunny.obj" }
local grey = material.matte { color = { 0.6, 0.6, 0.6 } }
local objects = { object { shape = mesh.plane { size = 100 }, scale = { 4, 1, 4 }, material = grey } }

local function near(place, spread) return place + spread * (2 * math.random() - 1) end
for layer = 0, 7 do
  for row = -12, 12 do
    for column = -12, 12 do
      objects[#objects + 1] = object {
        shape = bunny, material = grey, scale = 0.55,
        position = { near(column, 0.2), near(0.6 + 0.9 * layer, 0.1), near(row, 0.2) },
        rotation = { 360 * math.random(), 360 * math.random(), 360 * math.random() },
      }
    end
  end
end

return scene {
  film = { width = 320, height = 180, depth = 6, filter = "box", radius = 0.5 },
  camera = camera.perspective { from = { 16, 17, 24 }, at = { 0, 1.5, 0 }, fov = 36 },
  lights = {
    light.sky { color = { 0.6, 0.6, 0.6 } },
    light.area { position = { -10, 22, 10 }, at = { -10, 0, 10 }, size = { 8, 8 }, strength = 12 },
  },
  objects = objects,
}
