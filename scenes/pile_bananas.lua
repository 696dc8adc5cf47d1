-- A bunny of bananas (Sakurai 2013, figure 4.10 c) in twelve shapes, each of a tone of its own. With
-- --set support=remove what would fall is taken away.
local bunny_file = arg("bunny", "/usr/share/glmark2/models/bunny.obj")

local length = 0.18
local function tone(at, color, other) return { at = at, color = srgb(color), other = srgb(other) } end
-- From the cut stem to the tip; some are riper than others.
local peel = procedural.ramp {
  from = { -0.51 * length, 0, 0 }, to = { 0.51 * length, 0, 0 },
  stops = {
    tone(0.00, "#4a3620", "#3a2a18"), tone(0.02, "#5d4a24", "#4a3319"), tone(0.05, "#a3a23c", "#a98a2a"),
    tone(0.16, "#b9b63a", "#c9a128"), tone(0.30, "#e6c62e", "#e2b021"), tone(0.80, "#e9c833", "#dfa81f"),
    tone(0.93, "#b9ab3a", "#b3802a"), tone(0.962, "#6b5526", "#58381b"), tone(0.98, "#2a1c11", "#20150d"),
  },
}

local bunny = generator.pile {
  target = mesh.file { path = bunny_file, size = 2 },
  components = {
    {
      shape = mesh.banana { length = length },
      material = material.plastic { color = peel, roughness = 0.42 },
      variation = { shapes = 12, bend = 28, twist = 25, stretch = 0.1, scale = { 0.88, 1.12 } },
    },
  },
  rotation = { 70, 360, 70 }, refine = arg("refine", 3), cover = arg("cover", 0.95),
  support = arg("support", "report"), seed = arg("seed", 1),
}

local table_top = material.plastic { color = srgb("#8d9aa3"), roughness = 0.35 }
return scene {
  film = { width = 1280, height = 720, samples = 128, clamp = 4, depth = 10, exposure = 0.6 },
  camera = camera.perspective { from = { 1.3, 2.5, 5.4 }, at = { -0.05, 0.88, 0 }, fov = 25 },
  lights = {
    light.sky { zenith = { 0.55, 0.72, 1.0 }, horizon = { 1.0, 0.98, 0.95 }, ground = { 0.3, 0.27, 0.24 }, strength = 0.7 },
    light.sun { direction = { -1.0, 1.1, 0.8 }, angle = 5, color = { 1.0, 0.93, 0.82 }, strength = 3 },
  },
  objects = {
    object { shape = mesh.plane { size = 100 }, material = table_top, position = { 0, -0.03, 0 } },
    bunny,
  },
}
