-- Fallen pine needles of three classes, as in figure 5 and table 1 of Kita & Miyata (2012): young,
-- dark and dry ones that come to shares of about 0.3, 0.3 and 0.4 on a square of 512 (here mm).
-- --set direction=random: each lies any way; whirl: about the middle.
-- Three drawings are baked to a texture without light, or to a drawing:
-- scree bake scenes/elements_matsuba.lua -o matsuba.png (or .svg); --set look=mesh: bent needles.
local plants = include("parts/plants.lua")
local direction = arg("direction", "whirl")
assert(direction == "whirl" or direction == "random", "direction: random or whirl")
local look = arg("look", "picture")
assert(look == "mesh" or look == "picture", "look: mesh or picture")

-- Sizes that leave about as many elements as in the paper: 332 lying any way, 297 in a whirl.
local any_way = direction == "random"
local sizes = { picture = { random = 17.2, whirl = 25.1 }, mesh = { random = 16.8, whirl = 30.3 } }
local size = mm(sizes[look][direction])
local pines = any_way and plants.open_pine or plants.pine
local side = 0.512

local function needles(variant, share, picture, bends, ...)
  local component
  if look == "picture" then
    component = { picture = "parts/pictures/matsuba_" .. picture .. ".svg", size = size }
  else
    local palette = {}
    for i, color in ipairs { ... } do
      palette[i] = srgb(color)
    end
    component = plants.sheet(pines[variant], size, material.plastic { palette = palette, roughness = 0.4 }, bends)
  end
  component.weight, component.margin, component.height = share, mm(0.3), mm(0.6)
  return component
end

return scene {
  film = { width = 960, height = 960, samples = 64, clamp = 8 },
  camera = camera.perspective { from = { 0, 3, 0 }, up = { 0, 0, -1 }, fov = 2 * math.deg(math.atan(side / 2, 3)) },
  lights = {
    light.sky { color = { 0.93, 0.97, 1.0 }, strength = 0.55 },
    light.sun { direction = { -1, 0.9, -0.7 }, angle = 3, color = { 1, 0.93, 0.82 }, strength = 2.3 },
  },
  objects = {
    generator.elements {
      domain = region.rectangle { width = side, depth = side },
      components = {
        needles(1, 0.32, "young", { curl = 16 }, "#7fa03c", "#93ad48", "#6e9438"),
        needles(2, 0.32, "dark", { curl = 22, twist = 10 }, "#3f6a3a", "#34593a", "#4b7540"),
        needles(3, 0.36, "dry", { curl = 10, twist = -12 }, "#b0722f", "#9a5f2b", "#c08a45"),
      },
      direction = not any_way and field.whirl { turn = 70 } or nil,
      rotation = any_way and { 0, 360 } or { -6, 6 }, -- room for what the whirl turns between two
      background = look == "picture" and "parts/pictures/washi.svg" or nil,
      seed = arg("seed", 1),
    },
    object { shape = mesh.plane { size = 4 }, material = material.matte { color = srgb("#e6dcc6") } },
  },
}
