"""
From a drawing
==============

The same three-centred arch, drawn in millimetres, from a DXF and from an SVG file, becomes a roof
over a winding path (``examples/from_dxf.toml``, parallel repeating) and that of a market stall
(``examples/from_svg.toml``, orthodiagonal).
"""

import math

import matplotlib.pyplot as plt
from drawing import (
    EXAMPLES,
    F_COLOUR,
    G_COLOUR,
    LOCKED,
    camera,
    draw_line,
    draw_pattern,
    draw_shell,
)

from orishell.design_file import read_design_file
from orishell.motion import find_assignment
from orishell.plot.scene import Camera
from orishell.shell.make import make_shell


def draw(name: str, view: Camera) -> None:
    """The locked shell of a design file with its curves, and its crease pattern."""
    shell = make_shell(read_design_file(EXAMPLES / name))
    sheet = shell.design.mechanism
    _, (left, right) = plt.subplots(1, 2, figsize=(13, 4.6), layout="constrained")
    draw_pattern(left, shell.motion.flat.positions, find_assignment(sheet))
    draw_shell(right, sheet.positions(LOCKED * sheet.target_drive), view)
    draw_line(right, shell.design.targets["f"], view, F_COLOUR, "f, from the drawing")
    draw_line(right, shell.design.targets["g"], view, G_COLOUR, "g")
    right.legend(frameon=False, loc="upper right")
    lock = shell.report.lock
    print(f"{name}: {lock.cause} at {math.degrees(lock.drive or math.nan)} degrees")


# %%
# From ``profile.dxf``, layer PROFILE.
#
# .. live:: from_dxf

draw("from_dxf.toml", camera(-68, 30))

# %%
# From ``profile.svg``, the path called profile.
#
# .. live:: from_svg

draw("from_svg.toml", camera(-58, 30))
