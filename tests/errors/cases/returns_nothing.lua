local toys = mesh.box {}
