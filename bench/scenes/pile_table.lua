-- The rows of table 4.1 (Sakurai 2013): which components, with C_radius, C_refine and the ranges of
-- rotation as printed. Sizes are not in print: each row's is chosen so that as many sites as it has
-- components find room on the shape, which is 15 cm long.
local bunny = mesh.file { path = "/usr/share/glmark2/models/bunny.obj", size = 0.15 }
local dragon_file = arg("dragon", "")
local dragon = dragon_file ~= "" and mesh.file { path = dragon_file, size = 0.15 } or bunny
local wave = include("../../scenes/parts/pile.lua").wave(0.15)

-- Components as large as their largest side [mm].
local function rice(s) return mesh.rice { length = mm(s), width = mm(0.4 * s) } end
local function banana(s) return mesh.banana { length = mm(s) } end
local function small_bunny(s) return mesh.file { path = "/usr/share/glmark2/models/bunny.obj", size = mm(s) } end
local function torus(s) return mesh.torus { radius = mm(s / 2 - s / 8), tube = mm(s / 8) } end
local function ball(s) return mesh.sphere { radius = mm(s / 2), segments = 32 } end
local function box(s) return mesh.box { width = mm(s), rounding = 0.1 } end
local function chestnut(s) return mesh.chestnut { width = mm(s) } end
local function gear(s) return mesh.gear { radius = mm(s / 2) } end
local function nut(s) return mesh.nut { diameter = mm(s / 1.85), thread = false } end
local function bolt(s) return mesh.bolt { diameter = mm(s / 5), length = mm(s * 0.85) } end

local upright, any, level = { 0, 360, 0 }, { 360, 360, 360 }, { 18, 18, 18 }
local rows = {
  ["4.10a"] = { bunny, { { rice, 17.86, 1, 2 } }, upright },
  ["4.10c"] = { bunny, { { banana, 57.45, 1, 2 } }, upright },
  ["4.10e"] = { bunny, { { small_bunny, 16.33, 1, 2 } }, upright },
  ["4.11a"] = { bunny, { { torus, 16.94, 4, 1 }, { ball, 8.47, 2, 2 }, { box, 6.05, 1, 3 } }, any },
  ["4.11b"] = { dragon, { { chestnut, 16.61, 3, 0.1 }, { rice, 8.307, 1, 1.5 } }, any },
  ["4.12a"] = { bunny, { { rice, 26.0, 1, 3 } }, any, T = 0 },
  ["4.12b"] = { bunny, { { rice, 17.34, 1, 3 } }, any, T = 1 },
  ["4.13b"] = { bunny, { { rice, 40.37, 1, 1 } }, { 0, 0, 0 } },
  ["4.13c"] = { bunny, { { rice, 40.37, 1, 1 } }, { 360, 0, 0 } },
  ["4.13d"] = { bunny, { { rice, 40.37, 1, 1 } }, { 0, 360, 0 } },
  ["4.13e"] = { bunny, { { rice, 40.37, 1, 1 } }, { 0, 0, 360 } },
  ["4.13f"] = { bunny, { { rice, 40.37, 1, 1 } }, { 0, 360, 360 } },
  ["4.13g"] = { bunny, { { rice, 40.37, 1, 1 } }, { 360, 0, 360 } },
  ["4.13h"] = { bunny, { { rice, 40.37, 1, 1 } }, { 360, 360, 0 } },
  ["4.13i"] = { bunny, { { rice, 40.37, 1, 1 } }, any },
  ["4.14a"] = { bunny, { { rice, 11.21, 2, 3 } }, level, frame = "global" },
  ["4.14b"] = { dragon, { { rice, 9.956, 2, 3 } }, level, frame = "global" },
  ["4.15a"] = { bunny, { { rice, 21.99, 1, 2 } }, any },
  ["4.15b"] = { bunny, { { rice, 19.79, 1, 2 } }, any },
  ["4.16a"] = { bunny, { { gear, 15.39, 7.5, 6 } }, upright },
  ["4.16b"] = { bunny, { { nut, 19.81, 7, 3 }, { bolt, 28.61, 2, 3 } }, any },
  ["4.16c"] = { dragon, { { gear, 71.73, 1, 1 } }, upright },
  ["4.16d"] = { dragon, { { nut, 9.348, 4, 6 }, { bolt, 10.91, 2, 6 } }, any },
  ["4.16e"] = { wave, { { gear, 11.56, 7.5, 6 } }, upright },
  ["4.16f"] = { wave, { { nut, 18.34, 7, 5.5 }, { bolt, 22.92, 1.5, 5 } }, any },
}

local row = rows[arg("row", "4.10a")]
local components = {}
for i, c in ipairs(row[2]) do
  components[i] = { shape = c[1](c[2] * arg("scale", 1)), material = material.matte {}, spacing = c[3], refine = c[4] }
end
return scene {
  camera = camera.perspective { from = { 0.1, 0.2, 0.5 }, at = { 0, 0.07, 0 }, fov = 25 },
  lights = { light.sky {} },
  objects = {
    generator.pile {
      method = arg("method", "thesis"), target = row[1], components = components, rotation = row[3],
      frame = row.frame or "surface", overlap = row.T or 0.2, measure = arg("measure", 500), seed = 1,
      cover = arg("cover", 0),
    },
  },
}
