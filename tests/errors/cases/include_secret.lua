local part = include("/etc/passwd")
return scene { objects = { part } }
