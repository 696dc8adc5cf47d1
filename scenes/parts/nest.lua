-- What the scenes of nests share: the shape that twigs fill, a ring around a hollow, and their look.
local pile = include("pile.lua")

return {
  shape = mesh.lathe { profile = {
    { 0, 0 }, { 0.05, 0.002 }, { 0.088, 0.022 }, { 0.1, 0.05 }, { 0.09, 0.062 }, { 0.072, 0.058 }, { 0.055, 0.034 }, { 0.03, 0.022 }, { 0, 0.019 },
  } },
  twigs = material.plastic { palette = pile.palette("#6b4f35", "#8a6a45", "#4f3a28", "#9a7c55", "#5d4a3a"), roughness = 0.6 },
}
