local size = = 3
