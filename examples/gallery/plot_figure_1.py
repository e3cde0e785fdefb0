r"""
Figure 1 of the paper: parallel repeating
=========================================

*Given in the paper*: the target curve :math:`f = -x^2` on :math:`[-1, 1]`, the datum curve
:math:`g = 5\sin(\pi x/10)` on :math:`[0, 20]`, m = 9 rows and n = 11 columns of inner vertices,
and that the columns' planes are perpendicular to g.

*Not given, chosen here*: the angle ξ = 50° (f admits up to 53.13°), flaps 0.3 wide that fold to
the right, no rotation of f, and where the vertices stand on f and g. So the pattern agrees in
kind, not edge by edge.

.. live:: figure1
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
from matplotlib.patches import Arc
from numpy.typing import NDArray

from orishell import ParallelRepeating
from orishell.design_file import read_design_file
from orishell.motion import find_assignment

Array = NDArray[np.float64]

file = read_design_file(EXAMPLES / "figure1.toml")
design = file.pattern.design(file.f, file.g)
sheet = design.mechanism
assert isinstance(sheet, ParallelRepeating)
first_point, first_axis = sheet.points[0], sheet.axes[0]
flat, locked = sheet.positions([0.0, sheet.target_drive])
middle, inner = sheet.grid.rows // 2, sheet.inner_columns

# %%
# **(a)** The crease pattern: all rows parallel, all columns straight. Column 1 (green) is to
# follow f, the middle row (red) g.

figure, axes = plt.subplots(num="figure-1a", figsize=(8, 3.4), layout="constrained")
draw_pattern(axes, flat, None)
axes.plot(*flat[:, 1, :2].T, color=F_COLOUR, linewidth=2.5)
axes.plot(*flat[middle, inner, :2].T, color=G_COLOUR, linewidth=2.5)

# %%
# **(b)** The final rigidly folded state, mountains red and valleys blue: it has halted because the
# first and the last column of panels are folded shut.

figure, axes = plt.subplots(num="figure-1b", figsize=(8, 4.6), layout="constrained")
view = camera(-70, 38)
draw_shell(
    axes, sheet.positions(LOCKED * sheet.target_drive), view, signs=find_assignment(sheet), line=1.0
)
draw_line(axes, design.targets["f"], view, F_COLOUR, "f")
draw_line(axes, design.targets["g"], view, G_COLOUR, "g")
axes.legend(loc="upper right", frameon=False)

# %%
# **(c)** Column 1 when locked: a staircase of two directions that enclose the constant angle ξ.

figure, axes = plane_axes("figure-1c", (6, 3.6))


def in_plane(points: Array) -> tuple[Array, Array]:
    """Points of column 1's plane: across g, and up."""
    across = (points @ [1, 1j, 0] - first_point) / first_axis
    return across.real, points[:, 2]


across, height = in_plane(locked[:, 1])
axes.plot(*in_plane(design.targets["f"]), color="0.6", linewidth=4, label="f")
axes.plot(across, height, "o-", color=F_COLOUR, markersize=4, label="column 1")
k = 3
directions = np.array([np.arctan2(height[i] - height[k], across[i] - across[k]) for i in (2, 4)])
start, stop = np.sort(np.rad2deg(directions % (2 * np.pi)))
axes.add_patch(Arc((across[k], height[k]), 0.24, 0.24, theta1=start, theta2=stop))
turned = np.deg2rad((start + stop) / 2)
axes.text(across[k] + 0.19 * np.cos(turned), height[k] + 0.19 * np.sin(turned), "ξ", va="center")
axes.legend(loc="upper right", frameon=False)

# %%
# **(d)** The middle row when locked, and the planes of the columns (grey). δ, "measured from the
# same side", are interior angles: each between a plane and a segment as seen from its own column.

figure, axes = plane_axes("figure-1d", (8, 4.2))
points, t = sheet.points, sheet.axes
axes.plot(*design.targets["g"][:, :2].T, color="0.75", linewidth=4, label="g")
for point, axis in zip(points, t, strict=True):
    ends = point + np.array([-1.2, 1.2]) * axis
    axes.plot(ends.real, ends.imag, color="0.5", linewidth=0.8)
axes.plot(points.real, points.imag, "o-", color=G_COLOUR, markersize=4, label="middle row")
odd = np.angle((points[1:] - points[:-1]) / t[:-1])
even = np.angle((points[:-1] - points[1:]) / t[1:])
deltas = np.abs(np.rad2deg(np.stack([odd, even], axis=-1).ravel()))
for i in range(1, 5):
    column, other = (i // 2, i // 2 + (1 if i % 2 else -1))
    towards = (points[other] - points[column]) / abs(points[other] - points[column])
    place = points[column] + 0.75 * (towards + t[column]) / abs(towards + t[column])
    axes.text(place.real, place.imag, f"δ$_{i}$", ha="center", va="center", fontsize=9)
axes.legend(loc="upper right", frameon=False)
print(", ".join(f"δ{i} = {delta:.2f}°" for i, delta in enumerate(deltas[:4], start=1)))
