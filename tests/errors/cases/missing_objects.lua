return scene { camera = camera.perspective { from = { 0, 1, 2 } } }
