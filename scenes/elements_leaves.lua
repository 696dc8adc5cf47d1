-- Wrapping paper of drawings, a tile without a seam: maple and ginkgo leaves, or with
-- --set season=spring petals of the cherry. To be baked, as pixels or as a drawing of symbols:
-- scree bake scenes/elements_leaves.lua -o leaves.png (or .svg)
local season = arg("season", "autumn")
assert(season == "autumn" or season == "spring", "season: autumn or spring")

local side = 0.3

local function drawing(name, size, weight)
  return { picture = "parts/pictures/" .. name .. ".svg", size = mm(size), weight = weight, margin = mm(0.5) }
end

local components = season == "spring" and {
  drawing("petal_pink", 20, 2), drawing("petal_rose", 17, 3), drawing("petal_white", 17, 3),
} or {
  drawing("maple_red", 31, 2), drawing("maple_orange", 24, 4), drawing("ginkgo", 20, 4),
}

return scene {
  film = { width = 960, height = 960, samples = 48 },
  camera = camera.perspective { from = { 0, 3, 0 }, up = { 0, 0, -1 }, fov = 2 * math.deg(math.atan(side / 2, 3)) },
  lights = { light.sky { strength = 1 } },
  objects = {
    generator.elements {
      domain = region.rectangle { width = side, depth = side },
      torus = true,
      components = components,
      rotation = { 0, 360 },
      background = "parts/pictures/paper.svg",
      seed = arg("seed", 1),
    },
    object { shape = mesh.plane { size = 2 }, position = { 0, -0.001, 0 }, material = material.matte { color = srgb("#f3ead6") } },
  },
}
