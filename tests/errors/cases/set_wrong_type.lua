--! set seed=many
local seed = arg("seed", 7)
return scene { objects = { object { shape = mesh.box {} } } }
