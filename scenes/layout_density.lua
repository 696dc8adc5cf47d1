-- Density by growing the exclusive regions, as in figure 14 of Sakurai & Miyata (2014): three boards
-- of bananas whose outlines are kept 0, 20 and 60 mm wider all round. --set which=gradient: one long
-- board on which a field of density grows them from left to right.
local which = arg("which", "boards")
assert(which == "boards" or which == "gradient", "which: boards or gradient")
local method = arg("method", "saturated")
local seed = arg("seed", 2)

local banana = mesh.banana { length = 0.18, thickness = 0.21, bend = 105 }
local peel = material.plastic {
  palette = { srgb("#e3b92c"), srgb("#e9c440"), srgb("#d8b02e"), srgb("#c9bd45") }, roughness = 0.5,
}
local lacquer = material.plastic { color = srgb("#2a8087"), roughness = 0.3 }

local objects = {
  object { shape = mesh.plane { size = 40 }, position = { 0, -0.03, 0 }, material = material.matte { color = srgb("#e5d6c0") } },
}

local function add_board(x, width, depth, layout)
  local w, d = width / 2, depth / 2
  layout.method, layout.seed = method, seed
  layout.domain = region.polygon { points = { { x - w, -d }, { x + w, -d }, { x + w, d }, { x - w, d } } }
  objects[#objects + 1] = generator.layout(layout)
  objects[#objects + 1] = object {
    shape = mesh.box { width = width + 0.05, height = 0.03, depth = depth + 0.05, rounding = 0.3 },
    position = { x, -0.015, 0 }, material = lacquer,
  }
end

if which == "gradient" then
  add_board(0, 3.24, 1.7, {
    epsilon = 0.05,
    components = { { shape = banana, material = peel, margin = 0.05 } },
    density = field.gradient { from = { -1.3, 0 }, to = { 1.5, 0 }, low = 0, high = 2 },
  })
else
  for i, margin in ipairs { 0, mm(20), mm(60) } do
    add_board((i - 2) * 1.12, 1.0, 1.7, { components = { { shape = banana, material = peel, margin = margin } } })
  end
end

return scene {
  film = { width = 1280, height = 720, samples = 64, clamp = 8 },
  camera = camera.perspective { from = { 0, 4.3, 2.1 }, at = { 0, 0, 0.06 }, fov = 26 },
  lights = {
    light.sky { zenith = { 0.5, 0.62, 0.85 }, horizon = { 1, 0.98, 0.94 }, ground = { 0.35, 0.32, 0.28 }, strength = 0.55 },
    light.sun { direction = { -1.1, 1.25, -0.5 }, angle = 4, color = { 1.0, 0.92, 0.8 }, strength = 3.2 },
  },
  objects = objects,
}
