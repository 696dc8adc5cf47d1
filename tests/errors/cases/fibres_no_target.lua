return scene {
  objects = {
    generator.fibres {
      count = 10,
    },
  },
}
