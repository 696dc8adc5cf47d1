local function ball(scene) return object { shape = mesh.sphere { radius = scene.radius } } end
for _, mm in ipairs { 1, 2 } do
  print("a length of " .. mm(3))
end
return scene { objects = { ball { radius = 1 } } }
