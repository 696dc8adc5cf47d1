--! memory 32
local tilt = field.function {
  width = 2, depth = 1,
  value = function(x, z)
    local kept = {}
    while x do kept[#kept + 1] = { x, z } end
  end,
}
return scene {}
