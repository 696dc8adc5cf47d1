-- Figure 15 of Okada et al. (1987): a word made of planes, as if cut from one block.
local solid = include("parts/solid.lua")

local size, thickness = 0.1, 0.045

local function word(material, y, z)
  return object {
    shape = mesh.text { text = arg("text", "NAGOYA"), size = size, height = thickness, bevel = 0 },
    material = material, position = { 0, y, z },
  }
end

local step = 0.085
return scene {
  film = { width = 1280, height = 720, samples = 64, clamp = 1 },
  camera = camera.perspective { from = { -0.42, 0.62, 1.5 }, at = { 0, 0.085, -0.03 }, fov = 14.2 },
  lights = solid.lights(0.25),
  objects = solid.studio {
    word(solid.marble {}, step, -0.1),
    word(solid.wood { axis = { 1, 0.12, 0.2 }, origin = { 0, -0.03, -0.02 } }, 0, 0.06),
    object { -- what the word behind stands on
      shape = mesh.box { width = 0.7, height = step, depth = 0.12, rounding = 0.02 },
      position = { 0, 0, -0.1 }, material = material.matte { color = { 0.36, 0.36, 0.37 } },
    },
  },
}
