--! set night=perhaps
local night = arg("night", false)
return scene { objects = { object { shape = mesh.box {} } } }
