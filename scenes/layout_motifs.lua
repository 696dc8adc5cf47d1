-- Motifs in the manner of Japanese stencils, as in figure 15 of Sakurai & Miyata (2014): flat
-- components at any angle until no more fits. --set torus=true: a tile that repeats without a seam,
-- to be baked, as in: scree bake scenes/layout_motifs.lua --set torus=true -o cloth.svg
local motifs = include("parts/motifs.lua")

local dye = motifs.dye
local paper, pink, red = "#f1e7d3", "#e9b3b4", "#c8452f"
local gold, sage, sky = "#d9a441", "#8fae8b", "#8fb3cf"

local width, depth = 1.6, 0.9
local torus = arg("torus", false)
local over = torus and 0 or 0.16 -- beyond the picture, which then ends in mid-motif

local cloth = generator.layout {
  method = arg("method", "saturated"),
  domain = region.rectangle { width = width + over, depth = depth + over },
  torus = torus,
  components = {
    motifs.component("sakura", 0.15, dye(pink, paper), 0.004),
    motifs.component("ogi", 0.19, dye(red, gold), 0.004),
    motifs.component("chidori", 0.15, dye(paper, sky), 0.004),
    motifs.component("kiku", 0.17, dye(paper, gold), 0.004),
    motifs.component("momiji", 0.14, dye(red, "#d9743a"), 0.004),
    motifs.component("ginkgo", 0.12, dye(gold, sage), 0.004),
    motifs.component("ume", 0.09, dye(pink, red, paper), 0.003),
    motifs.component("sakura", 0.066, dye(pink, paper), 0.003),
  },
  seed = arg("seed", 1),
}

return scene {
  film = { width = 1280, height = 720, samples = 48 },
  camera = camera.perspective { from = { 0, 5, 0 }, up = { 0, 0, -1 }, fov = 2 * math.deg(math.atan(depth / 2, 5)) },
  lights = {
    light.sky { color = { 0.96, 0.98, 1.0 }, strength = 0.62 },
    light.sun { direction = { -1, 1.1, -0.8 }, angle = 6, color = { 1, 0.95, 0.86 }, strength = 1.7 },
  },
  objects = {
    cloth,
    object { shape = mesh.plane { size = 4 }, material = material.matte { color = srgb("#2b4170") } },
  },
}
