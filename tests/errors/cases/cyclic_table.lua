local t = { 1 }
t[2] = t
local box = mesh.box {}
box.parent = box
return scene {
  objects = t,
  lights = { box },
}
