return scene {
  objects = { generator.leather { resolution = 513 } },
}
