local size = arg(7)
