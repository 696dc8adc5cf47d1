local box = mesh { size = 1 }
