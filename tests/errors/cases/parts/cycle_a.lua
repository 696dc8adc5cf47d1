return include("cycle_b.lua")
