-- 400 things, matte and of metal, under 200 small lamps.
math.randomseed(3)
local metal = material.metal { color = { 0.9, 0.75, 0.5 }, roughness = 0.3 }
local matte = material.matte { palette = { { 0.7, 0.3, 0.2 }, { 0.3, 0.5, 0.6 }, { 0.7, 0.7, 0.65 } } }
local shapes = { mesh.torus { radius = 0.14 }, mesh.sphere { radius = 0.16 }, mesh.duck { length = 0.35 } }
local objects = { object { shape = mesh.plane { size = 40 }, material = material.matte { color = { 0.5, 0.5, 0.5 } } } }
for row = -9.5, 9.5 do
  for column = -9.5, 9.5 do
    objects[#objects + 1] = object {
      shape = shapes[math.random(#shapes)], material = math.random() < 0.5 and metal or matte,
      position = { 0.5 * column, 0, 0.5 * row }, rotation = { 0, 360 * math.random(), 0 },
    }
  end
end

local lights = {}
for row = -4.5, 4.5 do
  for column = -9.5, 9.5 do
    local x, y, z = 0.5 * column, 2.4 + 0.6 * math.random(), row
    local hue = math.random()
    lights[#lights + 1] = light.area {
      position = { x, y, z }, at = { x + math.random() - 0.5, 0, z + math.random() - 0.5 }, size = { 0.08, 0.08 },
      color = { 1, 0.6 + 0.3 * hue, 0.3 + 0.6 * hue }, strength = 20 + 40 * math.random(),
    }
  end
end

return scene {
  film = { width = 320, height = 180, depth = 6, filter = "box", radius = 0.5 },
  camera = camera.perspective { from = { 0, 2.1, 7 }, at = { 0, -1, 0 }, fov = 40 },
  lights = lights,
  objects = objects,
}
