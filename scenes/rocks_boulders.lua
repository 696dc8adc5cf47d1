-- Boulders half buried in hilly ground, grown over with lichen.
local rocks = include("parts/rocks.lua")

-- Hills of a few waves; no two periods share a multiple nearby.
local function height(x, z)
  return 0.35 * math.sin(0.7 * x + 0.4) * math.cos(0.55 * z) + 0.16 * math.sin(1.7 * x - 1.3 * z) + 0.05 * math.sin(4.1 * x + 3.7 * z + 1)
end
local ground = mesh.terrain { height = field["function"] { value = height, width = 30, depth = 30, resolution = 512 }, width = 30, depth = 30, columns = 384 }

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 64), clamp = 6 },
  camera = camera.perspective { from = { 0.5, 2.1, 6.4 }, at = { 0.2, -0.62, 0.6 }, fov = 36 },
  lights = rocks.daylight({ -1.0, 0.55, 0.2 }),
  objects = {
    generator.rocks {
      preset = "moraine", ground = ground,
      domain = region.rectangle { width = 14, depth = 13 },
      smallest = 0.05, largest = 1.6, exponent = 2.1, cover = arg("cover", 0.35), burial = 0.4,
      materials = {
        rocks.old(rocks.granite_texture("bianco_sardo"), 0.45, 0.3),
        rocks.old(rocks.sandstone_texture({ 0.33, 0.31, 0.28 }), 0.35, 0.3),
        rocks.old(rocks.sandstone_texture({ 0.27, 0.26, 0.25 }), 0.5, 0.3),
      },
      ground_material = rocks.sand,
      measure = arg("measure", 0), seed = arg("seed", 1),
    },
  },
}
