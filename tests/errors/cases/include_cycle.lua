local part = include("parts/cycle_a.lua")
