-- Hair on the bunny: fibres that begin on its surface and bend down and back.
local pile = include("parts/pile.lua")
local bunny = mesh.file { path = arg("bunny", "/usr/share/glmark2/models/bunny.obj"), size = 0.2 }
return scene {
  film = { width = 1280, height = 720, samples = 128 },
  camera = camera.perspective { from = { -0.14, 0.3, 0.62 }, at = { -0.005, 0.086, 0 }, fov = 22 },
  lights = pile.lights(0.2, 0.9),
  objects = {
    pile.table_top(0.2, srgb("#7f909b")),
    object { shape = bunny, material = material.matte { color = srgb("#6b5138") } },
    generator.fibres {
      roots = bunny, count = arg("count", 20000), length = { 0.012, 0.02 }, segments = 12, radius = mm(0.06), taper = 0.2,
      theta = { -6, 6 }, flow = 0, flow_rise = -40, flow_strength = 0.12, seed = arg("seed", 1),
      material = material.fibre { preset = "hair", color = srgb("#8a6b4a") },
    },
  },
}
