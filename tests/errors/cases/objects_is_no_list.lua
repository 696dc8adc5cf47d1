return scene { objects = object { shape = mesh.box {} } }
