local f = coroutine.wrap(function()
  error("inside")
end)
f()
