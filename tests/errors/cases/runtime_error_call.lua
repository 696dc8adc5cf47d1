local t = {}
t.make()
