local part = include("parts/broken.lua")
