"""
From a crease pattern
=====================

A crease pattern for Origami Simulator (``examples/arch_pattern.svg``: red mountains, blue valleys)
becomes a roof of boards on a membrane (``examples/arch_pattern.toml``). Nothing else is asked for:
from the flat sheet all fold angles follow in closed form.

One command each: does it fold; states of the sheet alone; boards, pack, ties, structure, and files
for the workshop.

.. code-block:: console

   $ orishell check arch_pattern.svg
   $ orishell fold arch_pattern.svg --out folded
   $ orishell design arch_pattern.toml --out arch --write step,dxf,pdf,csv

.. live:: arch_pattern
"""

import matplotlib.pyplot as plt
import numpy as np
from drawing import EXAMPLES, camera, draw_boards, draw_pattern, same_scale

from orishell.design_file import read_design_file
from orishell.motion import find_assignment
from orishell.shell.make import make_shell

shell = make_shell(read_design_file(EXAMPLES / "arch_pattern.toml"))
sheet, boards = shell.design.mechanism, shell.document.boards
assert boards is not None

# %%
# The pattern, as it was read.

flat = sheet.positions(0.0)
figure, axes = plt.subplots(figsize=(8, 6), layout="constrained")
draw_pattern(axes, flat, find_assignment(sheet))

# %%
# Its boards: in the pack, which they allow; half-way to the target; and there.

faces, lying = sheet.grid.faces_vertices(), flat.reshape(-1, 3)[:, :2]
COLOURS = np.tile([0.93, 0.80, 0.58], (len(boards.outlines), 1))
view = camera(-55, 24)
figure, frames = plt.subplots(1, 3, figsize=(10, 3), layout="constrained")
for drive, title, axes in zip(
    (shell.lock.closes_to, 0.5 * sheet.target_drive, sheet.target_drive),
    ("pack", "half-way", "target"),
    frames,
    strict=True,
):
    corners = boards.carried(faces, lying, sheet.positions(drive).reshape(-1, 3))
    draw_boards(axes, corners, view, COLOURS)
    axes.set_title(title)
same_scale(list(frames))
