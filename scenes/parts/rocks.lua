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
function parts.sandstone(color, size)
  return material.matte { color = procedural.stone { preset = "red_sandstone", color = color, contrast = 0.4, size = size or 0.5, relief = 0.0012, vary = true } }
end

function parts.granite(preset, size)
  return material.matte { color = procedural.granite { preset = preset, size = size or 0.05, relief = 0.0006, vary = true } }
end

parts.earth = material.matte { color = { 0.16, 0.13, 0.10 } }
parts.sand = material.matte { color = { 0.30, 0.26, 0.20 } }

return parts
