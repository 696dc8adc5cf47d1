--! seconds 0.3
local text = string.rep("a", 40000)

local at = text:find(string.rep(".-", 60) .. "b")
