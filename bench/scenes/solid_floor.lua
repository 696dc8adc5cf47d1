-- A marble floor to the horizon under an even sky: all that differs between samples is the texture.
return scene {
  film = { width = 512, height = 256, samples = 4 },
  camera = camera.perspective { from = { 0, 1.6, 0 }, at = { 0, 1.1, -4 }, fov = 40 },
  lights = { light.sky { color = { 1, 1, 1 } } },
  objects = {
    object {
      shape = mesh.plane { size = 100 },
      material = material.matte {
        color = procedural.marble { preset = "banded", size = 1, filtered = arg("filtered", "yes") == "yes" },
      },
    },
  },
}
