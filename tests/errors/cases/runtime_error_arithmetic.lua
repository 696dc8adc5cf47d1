local size
local twice = 2 * size
