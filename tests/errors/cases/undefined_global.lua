local box = meshes.box {}
