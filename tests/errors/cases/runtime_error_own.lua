error("there are no toys")
