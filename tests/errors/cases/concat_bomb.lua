--! memory 32
local text = string.rep("x", 1000)
while true do
  text = text .. text
end
