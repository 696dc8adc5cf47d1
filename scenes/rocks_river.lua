-- A river bed: boulders, cobbles and pebbles that the water has packed like tiles. It has just
-- fallen: what stood out of it is dry.
local rocks = include("parts/rocks.lua")
local function wet(texture) return rocks.wet(texture, arg("water", 0.045), 0.02) end
local function stone(r, g, b) return wet(rocks.sandstone_texture({ r, g, b }, 0.25)) end
local function granite(preset) return wet(rocks.granite_texture(preset)) end

return scene {
  film = { width = 1280, height = 720, samples = arg("samples", 64), clamp = 6 },
  camera = camera.perspective { from = { 0.1, 0.95, 1.35 }, at = { 0, -0.05, 0.2 }, fov = 40 },
  lights = rocks.daylight({ -1.0, 0.8, 0.1 }),
  objects = {
    generator.rocks {
      preset = "river",
      domain = region.rectangle { width = 3.4, depth = 3.5 },
      sizes = { { radius = 0.22, share = 0.12 }, { radius = 0.075, share = 0.33 }, { radius = 0.026, share = 0.55 } },
      cover = arg("cover", 1.2),
      materials = {
        stone(0.33, 0.32, 0.30), stone(0.26, 0.27, 0.28), granite("bianco_sardo"), stone(0.42, 0.33, 0.25),
        stone(0.38, 0.37, 0.33), granite("rosa_porrino"), stone(0.20, 0.21, 0.22), stone(0.48, 0.45, 0.40),
      },
      ground_material = rocks.sand,
      measure = arg("measure", 0), seed = arg("seed", 1),
    },
  },
}
