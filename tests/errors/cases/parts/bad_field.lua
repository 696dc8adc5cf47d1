return object {
  shape = mesh.box {},
  colour = 3,
}
