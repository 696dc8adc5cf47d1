local toys

local first = toys.first
