"""Matrix expressions and screw algebra: the language in which the blocks state their mathematics."""
