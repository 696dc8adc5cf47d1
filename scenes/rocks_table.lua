-- The columns of Table 1 of Sakurai & Miyata: --set column=fig1, fig11a, ... fig14c, and
-- --set method=mosaic for rocks that leave no gaps. A pixel of the paper is a millimetre.
local rocks = include("parts/rocks.lua")
local column = arg("column", "fig1")
local method = arg("method", "paper")

-- { r, A_s, c_w1, c_w2, c_w3, c_h1, c_h2, c_h3 }
local columns = {
  fig1 = { { 90, 0.2, 0, 6, 6, 14, 14, 9 }, { 30, 0.24, 0, 6, 2, 5, 5, 3 }, { 10, 0.56, 2, 2, 2, 2, 2, 1 } },
  fig11a = { { 90, 0.5, 0, 0, 0, 45, 0, 0 } },
  fig11b = { { 30, 0.5, 0, 0, 0, 15, 0, 0 } },
  fig11c = { { 10, 0.5, 0, 0, 0, 5, 0, 0 } },
  fig12a = { { 90, 0.5, 0, 0, 0, 45, 0, 0 }, { 30, 0.25, 0, 0, 0, 15, 0, 0 }, { 10, 0.25, 0, 0, 0, 5, 0, 0 } },
  fig12b = { { 90, 0.25, 0, 0, 0, 45, 0, 0 }, { 30, 0.5, 0, 0, 0, 15, 0, 0 }, { 10, 0.25, 0, 0, 0, 5, 0, 0 } },
  fig12c = { { 90, 0.25, 0, 0, 0, 45, 0, 0 }, { 30, 0.25, 0, 0, 0, 15, 0, 0 }, { 10, 0.5, 0, 0, 0, 5, 0, 0 } },
  fig13a = { { 90, 0.5, 10, 0, 0, 45, 0, 0 } },
  fig13b = { { 90, 0.5, 0, 10, 0, 45, 0, 0 } },
  fig13c = { { 90, 0.5, 0, 0, 10, 45, 0, 0 } },
  fig14a = { { 90, 0.5, 0, 0, 0, 67, 0, 0 } },
  fig14b = { { 90, 0.5, 0, 0, 0, 0, 45, 0 } },
  fig14c = { { 90, 0.5, 0, 0, 0, 0, 0, 45 } },
}

local sizes = {}
for i, c in ipairs(columns[column] or error("no column " .. column)) do
  sizes[i] = { radius = mm(c[1]), share = c[2], widening = { mm(c[3]), mm(c[4]), mm(c[5]) }, height = { mm(c[6]), mm(c[7]), mm(c[8]) } }
end

return scene {
  film = { width = 960, height = 720, samples = arg("samples", 48), clamp = 6 },
  camera = camera.perspective { from = { 0, 0.95, 1.05 }, at = { 0, 0, 0.02 }, fov = 38 },
  lights = rocks.daylight({ -1.0, 0.8, 0.2 }),
  objects = {
    object { shape = mesh.plane { size = 40 }, material = rocks.earth },
    generator.rocks {
      method = method, domain = region.rectangle { width = 0.953, depth = 0.953 }, sizes = sizes,
      material = rocks.sandstone({ 0.38, 0.35, 0.31 }, 0.1), seed = arg("seed", 1),
    },
  },
}
