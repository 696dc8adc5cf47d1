return scene {
  objects = {},
  lights = {
    field.function {
      width = 2, depth = 1,
      value = function(x, z) if x > 0 then return 1 end end,
    },
  },
}
