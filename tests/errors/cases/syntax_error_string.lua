local name = "bunny
return scene {}
