local b = 1 < "2"
