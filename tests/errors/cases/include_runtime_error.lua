local part = include("parts/fails.lua")
