local part = include("../parts/box.lua")
return scene { objects = { part } }
