local box = mesh.box(mesh.banana {})
