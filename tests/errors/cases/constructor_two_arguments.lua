local box = mesh.box({}, {})
