local c = srgb("red")
