local part = include("parts")
