--! seconds 0.3
local spin = coroutine.wrap(function()
  while true do end
end)
spin()
