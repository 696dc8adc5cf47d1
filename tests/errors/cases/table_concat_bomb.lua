--! memory 32
local list = {}
for i = 1, 100 do list[i] = string.rep("x", 200000) end
local all = table.concat(list, ",")
