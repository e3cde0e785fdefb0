"""A small arch of 30 panels that takes no time, for tests of what it bears."""

SMALL_ARCH = """[shell]
family = "orthodiagonal"
unit = "m"
[target.f]
formula = "-x**2"
range = [-1, 1]
[target.g]
formula = "0.25*sin(pi*x/2)"
range = [0, 2]
[pattern]
rows = 5
columns = 5
flap = 0
depth = 0.12
heading_deg = 90
"""
