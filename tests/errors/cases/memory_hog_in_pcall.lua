--! memory 32
--! seconds 5
local all = {}
pcall(function()
  while true do all[#all + 1] = { 1, 2, 3 } end
end)
