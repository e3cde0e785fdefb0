r"""
Figure 3 of the paper: longitudinal linear repeating
====================================================

*Given in the paper*: the sector angles 85°, 80°, 95°, 100° and, to two decimals, those that solve
equation (4) with them; equal lengths down column 1; a radius that grows from r to 1.67 r.

*Not given, chosen here*: the arrangement of the angles, which the paper shows only in its picture
(this one satisfies equation (4) and folds rigidly), 7 rows and 9 columns, and sizes. The paper's
row lengths are random; here they are the most even ones (a linear program finds them), and the
line is as long as makes the radius grow 1.67-fold.

.. live:: figure3
"""

import matplotlib.pyplot as plt
import numpy as np
from drawing import (
    EXAMPLES,
    F_COLOUR,
    G_COLOUR,
    camera,
    draw_line,
    draw_pattern,
    draw_shell,
    same_scale,
)

from orishell import (
    LongitudinalPattern,
    curve_from_formulas,
    design_longitudinal_linear_repeating,
    parse_formula,
)
from orishell.design_file import read_design_file
from orishell.families.longitudinal_linear_repeating import Sectors, find_solutions
from orishell.motion import find_assignment
from orishell.shell.make import make_shell

# %%
# **(a)** One period: rows alternate between F rows (flat-foldable vertices) and S rows (straight
# columns), columns repeat every four. Letters without index 2 are the input, drawn red.

f = curve_from_formulas(parse_formula("cos(t)"), parse_formula("sin(t)"), 0.3, 2.8)
g = curve_from_formulas(None, parse_formula("0*x"), 0, 1.7)
first = Sectors.from_degrees([85, 80, 95, 100])
second = find_solutions(first)[0].second
period = design_longitudinal_linear_repeating(
    f,
    g,
    LongitudinalPattern(
        rows=2,
        columns=4,
        sector_deg=first.degrees,
        flap=0.3,
        row_lengths=[1, 1, 1],
        column_lengths=[1, 1, 1],
    ),
)
flat = period.mechanism.positions(0.0)[..., :2]

figure, axes = plt.subplots(num="figure-3a", figsize=(8, 5.4), layout="constrained")
draw_pattern(axes, period.mechanism.positions(0.0), None)
values = {
    name + str(k): float(degrees)
    for k, sectors in ((1, first), (2, second))
    for name, degrees in zip("αβγδ", sectors.degrees, strict=True)
}
for i in (1, 2):
    for j, k in enumerate((1, 2, 2, 1), start=1):
        # LU, LD, RD, RU of F and S vertices; the columns 2' and 1' are turned by half a turn.
        if i == 1:
            names = [("β", True), ("α", False), ("β", False), ("α", True)]
        else:
            names = [("δ", True), ("δ", False), ("γ", False), ("γ", True)]
        if j > 2:
            names = [(name, not pi) for name, pi in reversed(names)]
        arms = [flat[i - 1, j], flat[i, j - 1], flat[i + 1, j], flat[i, j + 1], flat[i - 1, j]]
        arms = [(arm - flat[i, j]) / np.linalg.norm(arm - flat[i, j]) for arm in arms]
        for (name, pi), before, after in zip(names, arms[:-1], arms[1:], strict=True):
            value = values[name + str(k)]
            drawn = np.rad2deg(np.arccos(before @ after))
            assert abs(drawn - (180 - value if pi else value)) < 1e-9  # as it is drawn, so it is
            x, y = flat[i, j] + 0.07 * (before + after) / np.linalg.norm(before + after)
            label = f"π − {name}$_{k}$" if pi else f"{name}$_{k}$"
            colour = "#d62728" if k == 1 else "black"
            side = "right" if x < flat[i, j, 0] else "left"
            axes.text(x, y, label, color=colour, ha=side, va="center", fontsize=8)
print(", ".join(f"{name} = {value:.2f}°" for name, value in values.items()))

# %%
# **(b)** The approximation of a circular shell. Column 1, with equal lengths, lies on an arc; the
# radius grows to 1.67 times that of the other end.

file = read_design_file(EXAMPLES / "figure3.toml")
design = file.pattern.design(file.f, file.g)
sheet = design.mechanism
figure, axes = plt.subplots(num="figure-3b", figsize=(8, 4.6), layout="constrained")
view = camera(-55, 28)
draw_shell(axes, sheet.positions(sheet.target_drive), view, signs=find_assignment(sheet), line=1.0)
draw_line(axes, design.targets["f"], view, F_COLOUR, "f")
draw_line(axes, design.targets["g"], view, G_COLOUR, "the line")
axes.legend(loc="upper right", frameon=False)
largest, smallest = np.array(design.parameters["radius"], dtype=float)
print(f"radius {smallest:.3f} to {largest:.3f}: {largest / smallest:.3f} times as large")

# %%
# **(c)** The paper's own question: four sector angles, the lengths of a row and of a column, no
# target. Equal lengths down column 1 and a row of 1.4, 0.23, 1.0, 1.9, repeated, fold until the
# rims meet, and the radius grows 1.66-fold: ``examples/sectors.toml``.
#
# .. live:: sectors

shell = make_shell(read_design_file(EXAMPLES / "sectors.toml"))
sheet = shell.design.mechanism
figure, frames = plt.subplots(1, 3, num="figure-3c", figsize=(11, 3.4), layout="constrained")
for axes, share in zip(frames, (0.0, 0.5, 1.0), strict=True):
    draw_shell(axes, sheet.positions(share * sheet.target_drive), camera(-55, 28))
    axes.set_title(f"v₁ = {np.rad2deg(share * sheet.target_drive):.2f}°")
same_scale(list(frames))
largest, smallest = np.array(shell.design.parameters["radius"], dtype=float)
print(f"radius {smallest:.3f} to {largest:.3f}: {largest / smallest:.3f} times as large")
