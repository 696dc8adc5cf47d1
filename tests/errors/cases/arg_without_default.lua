local size = arg("size")
