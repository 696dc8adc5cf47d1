local part = include("parts/nothing.lua")
