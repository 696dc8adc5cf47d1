local l = mm("ten")
