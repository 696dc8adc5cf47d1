return scene {
  objects = { object { shape = mesh.box { }, qqqqqqqqqqq = 1 } },
  xyzzyxyzzy = 3,
}
