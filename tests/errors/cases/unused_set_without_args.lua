--! set seed=3
return scene { objects = { object { shape = mesh.box {} } } }
