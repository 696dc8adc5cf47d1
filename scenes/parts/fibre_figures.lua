-- Parameters of figures 5.6 to 5.13 of Sakurai 2013 (tables 5.2 to 5.6): angles in degrees.
local straight = { theta = { 0, 0 }, phi = { 0, 0 } }
local curved = { theta = { 0, 10.8 }, phi = { 0, 0 } }
local varied = { theta = { -10.8, 10.8 }, phi = { 0, 0 } }
local spiral = { theta = { 0, 10.8 }, phi = { 0, 36 } }
local wool = { theta = { 7.2, 14.4 }, phi = { 7.2, 14.4 } }
local helix = { theta = { 7.2, 14.4 }, phi = { 28.8, 43.2 }, count = 512 }
local curl = { theta = { 28.8, 36 }, phi = { 7.2, 14.4 }, count = 512 }
local function with(figure, values)
  for key, value in pairs(figure) do
    if values[key] == nil then values[key] = value end
  end
  return values
end

local figures = {
  ["5.6a"] = straight, ["5.6b"] = curved, ["5.6c"] = varied, ["5.6d"] = spiral,
  ["5.7a"] = straight, ["5.7b"] = curved, ["5.7c"] = varied, ["5.7d"] = spiral,
  ["5.8a"] = with(spiral, { length = 20 }), ["5.8b"] = with(spiral, { length = 5 }),
  ["5.9a"] = with(spiral, { count = 1024 }), ["5.9b"] = with(spiral, { count = 512 }),
  ["5.10"] = { theta = { -25.2, 25.2 }, phi = { -25.2, 25.2 } },
  ["5.11b"] = with(straight, { segments = 6 }),
  ["5.11c"] = { theta = { -21.6, 21.6 }, phi = { 0, 0 }, segments = 6 },
  ["5.11d"] = { theta = { 21.6, 21.6 }, phi = { 0, 0 }, segments = 6 },
  ["5.11e"] = { theta = { 0, 21.6 }, phi = { 0, 0 }, segments = 6 },
  ["5.12b"] = wool, ["5.12c"] = with(wool, { count = 512 }), ["5.12d"] = helix, ["5.12e"] = curl,
  ["5.13b"] = wool, ["5.13c"] = with(wool, { count = 512 }), ["5.13d"] = helix, ["5.13e"] = curl,
}

-- The figure of that name, with the values that all have in common where it gives none.
return function(name)
  local figure = figures[name]
  if not figure then
    local names = {}
    for key in pairs(figures) do names[#names + 1] = key end
    table.sort(names)
    error("there is no figure " .. name .. "; there are " .. table.concat(names, ", "), 2)
  end
  return with({ count = 2048, segments = 32, length = 10 }, with(figure, {}))
end
