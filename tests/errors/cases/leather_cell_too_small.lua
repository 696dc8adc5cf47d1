return scene { objects = { generator.leather { preset = "fine_calf", size = 2 } } }
