assert(1 == 2, "the toys do not fit")
