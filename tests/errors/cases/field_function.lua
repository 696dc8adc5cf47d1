local tilt = field.function {
  width = 2, depth = 1,
  value = function(x, z)
    return 90 * sin(x)
  end,
}
return scene {}
