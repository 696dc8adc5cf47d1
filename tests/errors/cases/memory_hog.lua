--! memory 32
local all = {}
local n = 0
while true do n = n + 1 all[n] = { n, n, n } end
