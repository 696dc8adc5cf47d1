return object { shape = mesh.box {} }
