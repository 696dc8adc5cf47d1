local x =

return )
