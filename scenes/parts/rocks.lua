-- Light and materials of the scenes of rocks.
local parts = {}

-- A low sun from the left and a blue sky.
function parts.daylight(sun)
  return {
    light.sky { zenith = { 0.32, 0.5, 0.95 }, horizon = { 0.85, 0.9, 1.0 }, ground = { 0.25, 0.22, 0.18 }, strength = 0.55 },
    light.sun { direction = sun or { -1.0, 0.75, 0.45 }, angle = 0.53, color = { 1.0, 0.91, 0.78 }, strength = 3.6 },
  }
end

-- Stones of one quarry: beds and sand of the same colour family.
function parts.sandstone_texture(color, size)
  return procedural.stone { preset = "red_sandstone", color = color, contrast = 0.4, size = size or 0.5, relief = 0.0012, vary = true }
end

function parts.granite_texture(preset, size)
  return procedural.granite { preset = preset, size = size or 0.05, relief = 0.0006, vary = true }
end

function parts.sandstone(color, size)
  return material.matte { color = parts.sandstone_texture(color, size) }
end

-- Stone that water has wetted up to a height.
function parts.wet(texture, height, edge)
  return material.plastic { color = procedural.weathered { base = texture, wet_below = height, wet_edge = edge, roughness = 0.8 } }
end

-- Stone that has lain for long: lichen, and dust where it is level.
function parts.old(texture, lichen, dust)
  return material.matte { color = procedural.weathered { base = texture, lichen = lichen, lichen_size = 0.12, dust = dust or 0, dust_color = { 0.20, 0.17, 0.12 } } }
end

parts.earth = material.matte { color = { 0.16, 0.13, 0.10 } }
parts.sand = material.matte { color = { 0.30, 0.26, 0.20 } }

return parts
