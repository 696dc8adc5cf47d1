return scene { objects = { generator.leather { preset = "reptil", depth = -1, pores = 3 } } }
