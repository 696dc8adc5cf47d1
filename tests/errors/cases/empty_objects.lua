return scene { objects = {} }
