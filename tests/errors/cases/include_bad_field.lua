return scene { objects = { include("parts/bad_field.lua") } }
