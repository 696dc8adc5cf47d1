local leaf = "parts/gamma.png"
local function board(copies)
  return object { shape = mesh.plane {}, material = material.matte {
    color = procedural.image { path = leaf, copies = copies } } }
end
return scene { objects = { board({ 2, 1 }), board({ 0, 1 }) } }
