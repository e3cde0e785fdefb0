r"""
Figure 2 of the paper: orthodiagonal
====================================

*Given in the paper*: the target curve :math:`f = -x^2` on :math:`[-1, 1]`, the datum curve
:math:`g = 0.25\sin(\pi x/2)` on :math:`[0, 4]`, m = 9 rows and n = 13 columns of inner vertices.

*Not given, chosen here*: the zigzag about f (vertices 0.12 to either side of it, its ends cut
level), :math:`\alpha_0` (from f's plane being square to g's x axis), flaps 0.15 wide, and where
the vertices stand on g. So the pattern agrees in kind, not edge by edge.

.. live:: figure2
"""

import matplotlib.pyplot as plt
import numpy as np
from drawing import (
    EXAMPLES,
    F_COLOUR,
    G_COLOUR,
    LOCKED,
    camera,
    draw_line,
    draw_pattern,
    draw_shell,
    plane_axes,
)
from matplotlib.axes import Axes
from numpy.typing import NDArray

from orishell.design_file import read_design_file
from orishell.motion import find_assignment

Array = NDArray[np.float64]

file = read_design_file(EXAMPLES / "figure2.toml")
design = file.pattern.design(file.f, file.g)
sheet = design.mechanism
flat, locked = sheet.positions([0.0, sheet.target_drive])
middle, inner = sheet.grid.rows // 2, sheet.inner_columns

# %%
# **(a)** The crease pattern: all columns straight and parallel. Column 1 (green) is to follow f,
# the middle row (red) g.

figure, axes = plt.subplots(num="figure-2a", figsize=(6, 5.2), layout="constrained")
draw_pattern(axes, flat, None)
axes.plot(*flat[:, 1, :2].T, color=F_COLOUR, linewidth=2.5)
axes.plot(*flat[middle, inner, :2].T, color=G_COLOUR, linewidth=2.5)

# %%
# **(b)** The final rigidly folded state, mountains red and valleys blue: it has halted because the
# first and the last column of panels are folded shut.

figure, axes = plt.subplots(num="figure-2b", figsize=(7, 4.6), layout="constrained")
view = camera(-62, 34)
draw_shell(
    axes, sheet.positions(LOCKED * sheet.target_drive), view, signs=find_assignment(sheet), line=1.0
)
draw_line(axes, design.targets["f"], view, F_COLOUR, "f")
draw_line(axes, design.targets["g"], view, G_COLOUR, "g")
axes.legend(loc="upper right", frameon=False)

# %%
# **(c)** Column 1 when locked: a zigzag about f that turns left and right alternately. The angles
# β are measured from alternating sides.


def name_angles(axes: Axes, vertices: Array, symbol: str, distance: float) -> Array:
    """Write the angles of a polyline (N, 2) into their corners; return them in degrees."""
    back, on = (np.diff(vertices, axis=0)[part] for part in (slice(-1), slice(1, None)))
    back, on = (each / np.linalg.norm(each, axis=1)[:, None] for each in (-back, on))
    degrees = np.rad2deg(np.arccos((back * on).sum(axis=1)))
    for i, (corner, inward) in enumerate(zip(vertices[1:-1], back + on, strict=True), start=1):
        x, y = corner + distance * inward / max(np.linalg.norm(inward), 1e-9)
        axes.text(x, y, f"{symbol}$_{{{i}}}$", ha="center", va="center", fontsize=8)
    return np.asarray(degrees)


figure, axes = plane_axes("figure-2c", (6, 3.8))
column = np.stack([-locked[:, 1, 1], locked[:, 1, 2]], axis=-1)  # f's plane is square to x
f = design.targets["f"]
axes.plot(-f[:, 1], f[:, 2], color="0.75", linewidth=4, label="f")
axes.plot(*column.T, "o-", color=F_COLOUR, markersize=4, label="column 1")
betas = name_angles(axes, column, "β", 0.09)
axes.legend(loc="upper right", frameon=False)
print(", ".join(f"{beta:.2f}°" for beta in betas))

# %%
# **(d)** The middle row when locked. The angles :math:`\gamma_i` are measured from the same side,
# so one of them exceeds 180° wherever g bends the other way; written here is the smaller angle of
# the two.

figure, axes = plane_axes("figure-2d", (8, 2.4))
row = locked[middle, inner, :2]
axes.plot(*design.targets["g"][:, :2].T, color="0.8", linewidth=4, label="g")
axes.plot(*row.T, "o-", color=G_COLOUR, markersize=4, label="middle row")
gammas = name_angles(axes, row, "γ", 0.09)
axes.legend(loc="upper right", frameon=False)
print(", ".join(f"{gamma:.2f}°" for gamma in gammas))
