return scene { objects = { object { mesh.box {} } } }
