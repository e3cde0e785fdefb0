"""Design files to begin with, one for each family."""

from __future__ import annotations

PARALLEL_REPEATING = """\
[shell]
family = "parallel-repeating"
unit = "m"                  # mm, cm, m, in, ft

[target.f]                  # the curve that is swept, in its own plane
formula = "-x**2"           # y(x); or a pair, x(t) and y(t): ["t", "-t**2"]
range = [-1, 1]
# points = "profile.csv"    # instead of formula and range: points, one "x, y" a line; or
# svg = "profile.svg"       # a drawing, with id = "..." of a path or group; or
# dxf = "profile.dxf"       # a drawing, with layer = "..." or handle = "..."
# unit = "mm"               # of the file, if it does not say so itself
# smooth = true             # a spline through the points; false: exactly as drawn
# part = [0, 1]             # keeps this part, by the length from its beginning; for formulas: range
# scale = 1.0               # enlarges the curve about its origin

[target.g]                  # the curve that it is swept along
formula = "5*sin(pi*x/10)"
range = [0, 20]

[pattern]
rows = 9                    # rows of inner vertices, odd
columns = 11                # columns of inner vertices
flap = 0.3                  # width of the locking panels; "auto"; 0: none, then it does not lock
xi_deg = 50                 # angle between the creases of column 1 when locked; "auto"
theta_deg = 0               # turns f in its plane; "auto"
plane_deg = 90              # angle between f's plane and g's tangent
spacing = "curvature"       # columns stand closer where g bends; "equal": at equal lengths
placement = "inscribed"     # columns stand on g; "balanced": beyond, so that both sides err alike

# [tolerance]               # instead of rows and columns: the program chooses them
# surface = 0.05            # largest distance between shell and surface
# panel_min = 0.1           # shortest and
# panel_max = 2             # longest edge of a panel

[motion]
frames = 25                 # states written, flat to locked
"""

ORTHODIAGONAL = """\
[shell]
family = "orthodiagonal"
unit = "m"                  # mm, cm, m, in, ft

[target.f]                  # the curve that is swept, in its own plane
formula = "-x**2"           # y(x); or a pair, x(t) and y(t): ["t", "-t**2"]
range = [-1, 1]
# points = "profile.csv"    # instead of formula and range: points, one "x, y" a line; or
# svg = "profile.svg"       # a drawing, with id = "..." of a path or group; or
# dxf = "profile.dxf"       # a drawing, with layer = "..." or handle = "..."
# unit = "mm"               # of the file, if it does not say so itself
# smooth = true             # a spline through the points; false: exactly as drawn
# part = [0, 1]             # keeps this part, by the length from its beginning; for formulas: range
# scale = 1.0               # enlarges the curve about its origin

[target.g]                  # the curve that it is swept along
formula = "0.25*sin(pi*x/2)"
range = [0, 4]

[pattern]
rows = 9                    # rows of inner vertices, odd
columns = 13                # columns of inner vertices
flap = 0.15                 # width of the locking panels; "auto"; 0: none, then it does not lock
depth = 0.12                # of the corrugation: vertices this far from f on both sides; "auto"
heading_deg = 90            # angle between f's plane and g's x axis; "auto"
spacing = "curvature"       # columns stand closer where g bends; "equal": at equal lengths
placement = "inscribed"     # columns stand on g; "balanced": beyond, so that both sides err alike

# [tolerance]               # instead of rows and columns: the program chooses them
# surface = 0.05            # largest distance between shell and surface
# panel_min = 0.1           # shortest and
# panel_max = 2             # longest edge of a panel

[motion]
frames = 25                 # states written, flat to locked
"""

LONGITUDINAL_LINEAR_REPEATING = """\
[shell]
family = "longitudinal-linear-repeating"
unit = "m"                  # mm, cm, m, in, ft

# without both targets: as far as it folds, and lengths are lengths
[target.f]                  # the curve that is swept, in its own plane: convex
formula = ["cos(t)", "sin(t)"]  # x(t), y(t); or y(x): "-x**2"
range = [0.3, 2.8416]
# points = "profile.csv"    # instead of formula and range: points, one "x, y" a line; or
# svg = "profile.svg"       # a drawing, with id = "..." of a path or group; or
# dxf = "profile.dxf"       # a drawing, with layer = "..." or handle = "..."
# unit = "mm"               # of the file, if it does not say so itself
# smooth = true             # a spline through the points; false: exactly as drawn
# part = [0, 1]             # keeps this part, by the length from its beginning; for formulas: range
# scale = 1.0               # enlarges the curve about its origin

[target.g]                  # the line that it is swept along: straight
formula = "0*x"
range = [0, 2.93]

[pattern]
rows = 7                    # rows of inner vertices
columns = 9                 # columns of inner vertices
sector_deg = [85, 80, 95, 100]  # alpha, beta, gamma, delta of column 1; "auto"
solution = 0                # which one of those that orishell solve lists
first_row = "F"             # kind of the first row: "F" or "S"
row_lengths = "auto"        # the most even ones; or 8 ratios, along the middle row
column_lengths = "auto"     # those that follow f; or 8 ratios, down column 1
stage_deg = "auto"          # fold angle of column 1 at which the shell meets f
flap = "auto"               # length of the row creases at the left and right border
couplings = "periodic"      # or 8 times "solve" or "parallel": columns without the period

# [tolerance]               # instead of rows and columns: the program chooses them
# surface = 0.05            # largest distance between shell and surface
# panel_min = 0.1           # shortest and
# panel_max = 2             # longest edge of a panel

[motion]
frames = 25                 # states written, flat to the stage
"""

WORKSHOP = """
# [workshop]                # how the flat sheet is drawn and cut (--write dxf,svg,pdf)
# palette = "plain"         # colours and line widths, for instance "lightburn"
# creases = "score"         # or "dashes", "perforation"
# relief_hole = 0.0         # diameter of a hole at every vertex
# labels = "none"           # or "panels", "creases", "both"
# stock = [1.2, 0.8]        # sheets that the pattern is split over, with joint = "tabs" or "strips"
# areal_density = 0.0       # kilograms per square metre
"""
