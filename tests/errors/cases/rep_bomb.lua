--! memory 32
local text = "x"

local all = text:rep(1e10)
