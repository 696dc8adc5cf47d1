// SPDX-License-Identifier: GPL-3.0-or-later
// Lua code that runs before a script. It removes what gives access to the system and replaces what
// is not deterministic (Lua seeds its hashes and random numbers differently in every process).
#include "scenes/reader/sandbox.h"

namespace scree {

const std::string_view prelude_source = R"lua(
local constructor, nearest = scree_constructor, scree_nearest
local usual_samples, least_samples, most_samples = scree_samples()
local type, next, rawget, rawset, rawlen, error = type, next, rawget, rawset, rawlen, error
local getmetatable, setmetatable, tostring, select = getmetatable, setmetatable, tostring, select
local integer_type, random_seed = math.type, math.randomseed
local format, match, gmatch, unpack = string.format, string.match, string.gmatch, table.unpack
local concat, floor = table.concat, math.floor

-- A deterministic total order of keys. Keys are distinct, so the sort need not be stable.
local rank = { number = 1, string = 2, boolean = 3 }
local function key_before(a, b)
  local type_a, type_b = type(a), type(b)
  if type_a ~= type_b then return rank[type_a] < rank[type_b] end
  if type_a == "boolean" then return b and not a end
  return a < b
end

-- Merge sort: stable and, unlike Lua's sort, deterministic (Lua's picks pivots by the clock).
local function sort(list, before)
  before = before or function(a, b) return a < b end
  local count = #list
  local from, to = list, {}
  local width = 1
  while width < count do
    for low = 1, count, 2 * width do
      local middle, high = low + width, low + 2 * width
      if middle > count + 1 then middle = count + 1 end
      if high > count + 1 then high = count + 1 end
      local left, right = low, middle
      for at = low, high - 1 do
        if left < middle and (right >= high or not before(from[right], from[left])) then
          to[at] = from[left]
          left = left + 1
        else
          to[at] = from[right]
          right = right + 1
        end
      end
    end
    from, to = to, from
    width = 2 * width
  end
  if from ~= list then
    for i = 1, count do list[i] = from[i] end
  end
end

local function check_table(value, name)
  if type(value) ~= "table" then
    error(name .. " takes a table, not a " .. type(value), 0)
  end
end

local function check_key(key)
  if not rank[type(key)] then
    error("a " .. type(key) .. " as a key has no order that is the same every run; "
          .. "use a number or a text", 0)
  end
end

local function sorted_keys(of)
  local keys, count, is_list, length = {}, 0, true, rawlen(of)
  for key in next, of do
    check_key(key)
    is_list = is_list and integer_type(key) == "integer" and key >= 1 and key <= length
    count = count + 1
    keys[count] = key
  end
  if is_list and count == length then
    for i = 1, count do keys[i] = i end
  else
    sort(keys, key_before)
  end
  return keys
end

function pairs(of)
  local meta = getmetatable(of)
  if type(meta) == "table" and rawget(meta, "__pairs") then
    local step, state, first = rawget(meta, "__pairs")(of)
    return step, state, first
  end
  check_table(of, "pairs")
  local keys, at = sorted_keys(of), 0
  return function()
    local key, value
    repeat -- a key may have been removed meanwhile
      at = at + 1
      key = keys[at]
      if key == nil then return nil end
      value = rawget(of, key)
    until value ~= nil
    return key, value
  end, of, nil
end

function _G.next(of, after)
  check_table(of, "next")
  local best, best_value
  for key, value in next, of do
    check_key(key)
    if (after == nil or key_before(after, key)) and (best == nil or key_before(key, best)) then
      best, best_value = key, value
    end
  end
  return best, best_value
end

function table.sort(list, before)
  check_table(list, "table.sort")
  sort(list, before)
end

-- Lua's text of a table contains its address, which differs from run to run.
local plain = { ["nil"] = true, boolean = true, number = true, string = true }
local function stable_text(value)
  if plain[type(value)] then return tostring(value) end
  local meta = getmetatable(value)
  if type(meta) == "table" and (rawget(meta, "__tostring") or rawget(meta, "__name")) then
    return tostring(value)
  end
  return type(value)
end
_G.tostring = stable_text

local say = print
function print(...)
  local texts = { ... }
  for i = 1, select("#", ...) do texts[i] = stable_text(texts[i]) end
  say(unpack(texts, 1, select("#", ...)))
end

function string.format(pattern, ...)
  if type(pattern) == "string" then
    for letter in gmatch(pattern, "%%[^%a%%]*([%a%%])") do
      if letter == "p" then error("%p differs from run to run; scripts cannot use it", 0) end
    end
  end
  local values = { ... }
  for i = 1, select("#", ...) do
    if not plain[type(values[i])] then values[i] = stable_text(values[i]) end
  end
  return format(pattern, unpack(values, 1, select("#", ...)))
end

function math.randomseed(...)
  local seed = ...
  if type(seed) ~= "number" then
    error("math.randomseed needs a number, so that the same script gives the same scene", 0)
  end
  random_seed(seed)
end
random_seed(0)

function _G.setmetatable(of, meta)
  if type(meta) == "table" and rawget(meta, "__gc") ~= nil then
    error("scripts cannot use __gc", 0)
  end
  if type(meta) == "table" and rawget(meta, "__mode") ~= nil then
    error("scripts cannot use __mode: what it keeps differs from run to run", 0)
  end
  return setmetatable(of, meta)
end

-- Replaces the function of a field.function by the text of its samples: "columns rows" and the
-- values, from -x to +x and from -z to +z. Invalid parameters are left unchanged here: the check of
-- all parameters reports them.
local function sampled(value, x, z)
  local number = value(x, z)
  local wrong
  if type(number) ~= "number" then
    wrong = type(number) == "nil" and "nothing" or "a " .. type(number)
  elseif number ~= number then
    wrong = "what is not a number (was zero divided by zero?)"
  elseif number < -1e9 or number > 1e9 then
    wrong = format("%.6g, which is too large", number)
  else
    return format("%.7g", number)
  end
  error(format("field.function.value: gives %s at x = %.6g, z = %.6g; expected a number",
               wrong, x, z), 0)
end

local function sample(field)
  local value, resolution = rawget(field, "value"), rawget(field, "resolution") or usual_samples
  if type(value) ~= "function" then return end
  field.value = ""
  local function positive(name)
    local number = rawget(field, name)
    return type(number) == "number" and number > 0 and number < 1e9 and number
  end
  local width, depth = positive("width"), positive("depth")
  local centre = rawget(field, "centre") or { 0, 0 }
  local fine = width and depth and type(centre) == "table" and type(centre[1]) == "number" and
               type(centre[2]) == "number" and type(resolution) == "number" and
               resolution >= least_samples and resolution <= most_samples
  if not fine then return end
  local function count(length)
    local share = floor(resolution * length / (width > depth and width or depth) + 0.5)
    return share > 2 and floor(share) or 2
  end
  local columns, rows, torus = count(width), count(depth), rawget(field, "torus") == true
  local function place(i, samples, length)
    return torus and ((i + 0.5) / samples - 0.5) * length or (i / (samples - 1) - 0.5) * length
  end
  local lines = { format("%d %d", columns, rows) }
  for row = 0, rows - 1 do
    local line, z = {}, centre[2] + place(row, rows, depth)
    for column = 0, columns - 1 do
      line[column + 1] = sampled(value, centre[1] + place(column, columns, width), z)
    end
    lines[row + 2] = concat(line, " ")
  end
  field.value = concat(lines, " ")
end

-- Every name in a family is a constructor, so that a misspelt one is reported together with all
-- other errors.
for _, family in next, scree_families() do
  _G[family] = setmetatable({}, {
    __index = function(made, name)
      if type(name) ~= "string" then
        error(family .. " is a family; write " .. family .. ".name { ... }", 0)
      end
      -- The loader rewrites field.function to this, since Lua allows no keyword as a name.
      if family == "field" and name == "Function" then name = "function" end
      local kind = family .. "." .. name
      local make = constructor(kind, kind == "field.function" and sample or nil)
      rawset(made, name, make)
      return make
    end,
    __newindex = function() error(family .. " cannot be changed", 0) end,
    __call = function()
      error(family .. " is a family; write " .. family .. ".name { ... }", 0)
    end,
    __metatable = false,
  })
end
object = constructor("object")
scene = constructor("scene")

local forbidden = { "io", "os", "package", "debug", "require", "load", "loadfile", "loadstring",
                    "dofile", "collectgarbage", "warn" }
local is_forbidden = { ["string.dump"] = true }
for _, name in next, forbidden do
  _G[name] = nil
  is_forbidden[name] = true
end
string.dump = nil
scree_constructor, scree_nearest, scree_samples, scree_families = nil, nil, nil, nil

local function strict(library, prefix)
  setmetatable(library, {
    __index = function(_, name)
      if type(name) ~= "string" then return nil end
      if is_forbidden[prefix .. name] then
        error("scripts cannot use " .. prefix .. name .. "; they only describe a scene", 0)
      end
      local known, count = {}, 0
      for key in next, library do
        if type(key) == "string" then
          count = count + 1
          known[count] = key
        end
      end
      sort(known)
      error(prefix .. name .. " is not known here" .. nearest(prefix, name, known), 0)
    end,
    __metatable = false,
  })
end
strict(string, "string.")
strict(table, "table.")
strict(math, "math.")
strict(utf8, "utf8.")
strict(coroutine, "coroutine.")
strict(_G, "")
getmetatable("").__metatable = false
)lua";

} // namespace scree
