local box = mesh.box(3)
