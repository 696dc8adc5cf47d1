--! set sede=3
--! set zzzzz=3
local seed = arg("seed", 7)
return scene { objects = { object { shape = mesh.box {} } } }
