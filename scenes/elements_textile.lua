-- A cloth of blossoms, hemp leaves, treasures and temari balls, classes that are each evenly spread by
-- themselves and all together. --set torus=true: a tile that repeats without a seam, to be baked:
-- scree bake scenes/elements_textile.lua --set torus=true -o cloth.png (or .svg)
local motifs = include("parts/motifs.lua")
local patterns = include("parts/patterns.lua")
local plants = include("parts/plants.lua")

local dye = motifs.dye
local side = 1.2
local torus = arg("torus", false)
local over = torus and 0 or 0.2 -- beyond the picture, which then ends in mid-motif

local function element(motif, size, weight, ...)
  return {
    shape = region.path { d = motif.outline .. motif.cuts, fill_rule = "evenodd", size = size },
    region = region.path { d = motif.outline, size = size },
    material = dye(...), weight = weight, margin = 0.003, height = size / 120,
  }
end

local cloth = generator.elements {
  domain = region.rectangle { width = side + over, depth = side + over },
  torus = torus,
  exclusion = "disk",
  components = {
    element(motifs.sakura, 0.104, 3, "#f4d3d0", "#eeb7b8"),
    element(patterns.asanoha, 0.1, 2, "#e3b65c"),
    element(patterns.temari, 0.1, 2, "#d5573f", "#c9472f"),
    element(patterns.shippo, 0.1, 2, "#9cc3c4", "#86b2b8"),
    -- Smaller ones, and as many as find room between the others.
    element(motifs.ume, 0.056, 6.5, "#f4ead8", "#e9c27a", "#e7a7a6"),
    element({ outline = plants.disk, cuts = "" }, 0.017, 9, "#f4ead8", "#9cc3c4"),
  },
  rotation = { 0, 360 },
  background = "parts/pictures/indigo.svg",
  seed = arg("seed", 1),
}

return scene {
  film = { width = 960, height = 960, samples = 48 },
  camera = camera.perspective { from = { 0, 6, 0 }, up = { 0, 0, -1 }, fov = 2 * math.deg(math.atan(side / 2, 6)) },
  lights = {
    light.sky { color = { 0.96, 0.98, 1.0 }, strength = 0.62 },
    light.sun { direction = { -1, 1.1, -0.8 }, angle = 6, color = { 1, 0.95, 0.86 }, strength = 1.7 },
  },
  objects = {
    cloth,
    object { shape = mesh.plane { size = 4 }, material = material.matte { color = srgb("#233a5e") } },
  },
}
