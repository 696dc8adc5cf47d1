return scene {
  objects = { generator.leather { preset = "pebbled",
    groove_width = mm(2.5) } },
}
