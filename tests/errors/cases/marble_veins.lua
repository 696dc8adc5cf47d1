local veins = {}
for i = 1, 33 do
  veins[i] = { at = i * 0.01 }
end
return scene {
  camera = camera.perspective { from = { 0, 1, 2 }, at = { 0, 0, 0 } },
  objects = {
    object { shape = mesh.box {}, material = material.matte { color = procedural.marble { veins = veins } } },
  },
}
