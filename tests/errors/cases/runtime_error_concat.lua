local t = {}
local s = "a" .. t
