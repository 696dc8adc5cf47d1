-- Hair on the bunny: fibres that begin on its surface and bend down and back.
local bunny = mesh.file { path = arg("bunny", "/usr/share/glmark2/models/bunny.obj"), size = 0.2 }

-- No two hairs beside each other have to be of one colour.
local tones = {}
for i, tone in ipairs { "#b08a5e", "#c29c6c", "#94704a", "#e0c499", "#6b4f36" } do tones[i] = srgb(tone) end

return scene {
  film = { width = 1280, height = 720, samples = 128, clamp = 8 },
  camera = camera.perspective { from = { -0.2, 0.29, 0.6 }, at = { 0.002, 0.094, 0 }, fov = 21.5 },
  lights = {
    -- A warm key from the upper left, two rims from behind, hardly any fill.
    light.area { position = { -0.75, 0.7, 0.25 }, at = { 0, 0.08, 0 }, size = { 0.3, 0.3 }, color = { 1.0, 0.93, 0.82 }, strength = 160 },
    light.area { position = { 1.6, 1.5, -1.6 }, at = { 0, 0.1, 0 }, size = { 0.7, 1.0 }, color = { 0.78, 0.88, 1.0 }, strength = 30 },
    light.area { position = { -1.3, 1.5, -2.0 }, at = { 0, 0.1, 0 }, size = { 0.6, 0.8 }, color = { 1.0, 0.86, 0.68 }, strength = 22 },
    light.sky { color = { 0.7, 0.8, 1.0 }, strength = 0.12 },
  },
  objects = {
    object { shape = mesh.plane { size = 30 }, material = material.matte { color = srgb("#2c3034") } },
    object { shape = bunny, material = material.matte { color = srgb("#5a4532") } },
    generator.fibres {
      roots = bunny, count = arg("count", 45000), length = { 0.009, 0.019 }, segments = 12, radius = mm(0.06), taper = 0.2,
      theta = { -6, 6 }, flow = 0, flow_rise = -40, flow_strength = 0.12, contact = arg("contact", false), seed = arg("seed", 1),
      material = material.fibre { preset = "hair", palette = tones, beta_m = 0.2, beta_n = 0.3 },
    },
  },
}
