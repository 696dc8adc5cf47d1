-- Hair on the bunny: fibres that begin on its surface and bend down and back, a short dark undercoat
-- below longer hairs of several colors.
local bunny = mesh.file { path = arg("bunny", "/usr/share/glmark2/models/bunny.obj"), size = 0.2 }

local function coat(count, length, radius, seed, tones)
  local palette = {}
  for i, tone in ipairs(tones) do palette[i] = srgb(tone) end
  return generator.fibres {
    roots = bunny, count = count, length = length, segments = 12, radius = radius, taper = 0.2,
    contact = arg("contact", true), theta = { -6, 6 }, flow = 0, flow_rise = -40, flow_strength = 0.12, seed = seed,
    material = material.fibre { preset = "hair", palette = palette, beta_m = 0.22, beta_n = 0.3 },
  }
end

return scene {
  film = { width = 1280, height = 720, samples = 128, clamp = 8 },
  camera = camera.perspective { from = { -0.2, 0.29, 0.6 }, at = { -0.006, 0.09, 0 }, fov = 19 },
  lights = {
    -- A warm key from the upper left, two rims from behind, hardly any fill.
    light.area { position = { -0.75, 0.7, 0.25 }, at = { 0, 0.08, 0 }, size = { 0.3, 0.3 }, color = { 1.0, 0.93, 0.82 }, strength = 160 },
    light.area { position = { 0.8, 0.75, -0.7 }, at = { 0, 0.1, 0 }, size = { 0.35, 0.5 }, color = { 0.78, 0.88, 1.0 }, strength = 30 },
    light.area { position = { -0.6, 0.7, -0.9 }, at = { 0, 0.1, 0 }, size = { 0.3, 0.4 }, color = { 1.0, 0.86, 0.68 }, strength = 22 },
    light.sky { color = { 0.7, 0.8, 1.0 }, strength = 0.12 },
  },
  objects = {
    object { shape = mesh.plane { size = 30 }, material = material.matte { color = srgb("#2c3034") } },
    object { shape = bunny, material = material.matte { color = srgb("#5a4532") } },
    coat(arg("count", 20000), { 0.012, 0.02 }, mm(0.06), arg("seed", 1), { "#b08a5e", "#c29c6c", "#94704a", "#d6b687", "#7d6046" }),
  },
}
