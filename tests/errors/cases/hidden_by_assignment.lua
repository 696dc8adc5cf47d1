scene = { lights = { light.sky {} } }
return scene { objects = { object { shape = mesh.sphere {} } } }
