local size = arg("size", { 1, 2 })
