--! seconds 0.3
local tilt = field.function {
  width = 2, depth = 1,
  value = function(x, z)
    while x do z = z + 1 end
  end,
}
return scene {}
