-- The same slabs of three different sides on a ball, with eight ranges of rotation about u, v and w
-- (Sakurai 2013, figure 4.13 b to i): none, then u, v, w, then v and w, u and w, u and v, and all.
local settings = {
  { 0, 0, 0 }, { 360, 0, 0 }, { 0, 360, 0 }, { 0, 0, 360 },
  { 0, 360, 360 }, { 360, 0, 360 }, { 360, 360, 0 }, { 360, 360, 360 },
}
local tones = {}
for i, tone in ipairs { "#d9822b", "#e0983f", "#cf6f22", "#e6ab5c" } do tones[i] = srgb(tone) end
-- A drop of three different widths, so that every turn shows.
local shape = mesh.gear { teeth = 8 }
local component = { shape = mesh.box { width = 0.055, height = 0.075, depth = 0.02, rounding = 0.3 }, material = material.plastic { palette = tones, roughness = 0.3 } }

local ball = mesh.sphere { radius = 0.2 }
local core = material.matte { color = { 0.2, 0.07, 0.02 } }

local objects = {
  object { shape = mesh.plane { size = 40 }, material = material.matte { color = { 0.42, 0.45, 0.48 } } },
}
for i, rotation in ipairs(settings) do
  local column, row = (i - 1) % 4, (i - 1) // 4
  local position = { (column - 1.5) * 0.62, 0.1, (row - 0.5) * 0.74 }
  objects[#objects + 1] = object { shape = ball, material = core, position = position }
  objects[#objects + 1] = generator.pile {
    target = ball,
    components = { component },
    rotation = rotation, refine = 2, cover = arg("cover", 0),
    position = position,
  }
end
return scene {
  film = { width = 1280, height = 720, samples = 64, clamp = 4, depth = 8, exposure = 0.1 },
  camera = camera.perspective { from = { 0, 3.1, 2.9 }, at = { 0, 0.2, 0.02 }, fov = 23 },
  lights = {
    light.sky { zenith = { 0.6, 0.75, 1.0 }, horizon = { 1.0, 0.98, 0.95 }, ground = { 0.3, 0.27, 0.24 }, strength = 0.7 },
    light.sun { direction = { -1.0, 1.4, 0.8 }, angle = 5, color = { 1.0, 0.93, 0.82 }, strength = 2.6 },
  },
  objects = objects,
}
