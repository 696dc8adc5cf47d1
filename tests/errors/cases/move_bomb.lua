--! seconds 0.3
local t = {}
table.move(t, 1, 2^53, 2)
