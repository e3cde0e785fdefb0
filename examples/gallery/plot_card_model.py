"""
Figure 1 in paper and card
==========================

Half of Figure 1 to build on a table: a sheet of A3 paper is the membrane, and boards of 2 mm card,
all from one sheet of A3, are glued on both its faces (``examples/figure1_card.toml``). Where a
crease closes, boards stand back from it by their height times the tangent of half the fold angle.

All of Figure 1, with 9 rows and 11 columns, would need sheets several times as large: on A3 boards
of 2 mm would leave nothing of its narrowest panels.

.. live:: figure1_card
"""

import math
import runpy
from pathlib import Path

import matplotlib.pyplot as plt
from drawing import EXAMPLES, LOCKED, camera, draw_shell
from matplotlib.axes import Axes

from orishell.motion import find_assignment
from orishell.workshop import Drawing
from orishell.workshop.palettes import load_palette
from orishell.workshop.sheets import draw_sheet_files

card = runpy.run_path(str(EXAMPLES / "figure1_card.py"))
shell = card["design"]()
files = draw_sheet_files(Path("pattern.svg"), shell.document, shell.file.workshop)
drawings = {path.name: drawing for path, drawing in files}
for name, value in card["measure"](shell).items():
    print(f"{name}: {value:.4g}")


def show(axes: Axes, drawing: Drawing) -> None:
    """A drawing for a machine, on the sheet that it is cut from."""
    pens = load_palette("plain").pens
    for line in drawing.lines:
        points = [*line.points, *line.points[: int(line.closed)]]
        axes.plot(*zip(*points, strict=True), color=pens[line.layer].colour, linewidth=0.8)
    for text in drawing.texts:
        if text.layer == "ENGRAVE":
            axes.annotate(
                text.words,
                (text.x, text.y),
                rotation=math.degrees(text.angle),
                rotation_mode="anchor",
                ha="center",
                va="center",
                fontsize=min(1.3 * text.height, 14),
            )
    axes.plot(
        [0, drawing.width, drawing.width, 0, 0],
        [0, 0, drawing.height, drawing.height, 0],
        color="0.8",
        linewidth=0.8,
    )
    axes.set_aspect("equal")
    axes.axis("off")


# %%
# The target: panels of no thickness, as they are designed, without the flaps that are clipped on.

sheet = shell.design.mechanism
figure, axes = plt.subplots(figsize=(8, 4), layout="constrained")
signs = find_assignment(sheet)
draw_shell(axes, sheet.positions(LOCKED * sheet.target_drive), camera(-65, 35), signs=signs, line=1)

# %%
# The paper, from above: creases to score, and the places of the upper boards with their part
# numbers. Both flaps are strips of their own.

figure, axes = plt.subplots(figsize=(10, 7.1), layout="constrained")
show(axes, drawings["pattern-1.svg"])

# %%
# The paper turned over: the places of the lower boards.

figure, axes = plt.subplots(figsize=(10, 7.1), layout="constrained")
show(axes, drawings["pattern-back-1.svg"])

# %%
# The card: T goes on top, B below, each where its number is.

figure, axes = plt.subplots(figsize=(10, 7.1), layout="constrained")
show(axes, drawings["pattern-boards-1.svg"])
