return { objects = {} }
