return scene { object { shape = mesh.box {} } }
