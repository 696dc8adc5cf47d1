return include("cycle_a.lua")
