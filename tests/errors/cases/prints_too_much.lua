for i = 1, 100000 do
  print("this text is too long to be said so often")
end
