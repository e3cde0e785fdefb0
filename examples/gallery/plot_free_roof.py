"""
A free roof from a mesh
=======================

A mesh as it comes out of a modelling program: ``examples/roof.obj``, a target in
``examples/free_roof.toml``. Four corners of its rim become those of the sheet.

.. live:: free_roof
"""

import matplotlib.pyplot as plt
from drawing import EXAMPLES, camera, draw_pattern, draw_shell, same_scale

from orishell.design_file import read_design_file
from orishell.motion import find_assignment
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES

file = read_design_file(EXAMPLES / "free_roof.toml").changed({"panel": None})
shell = make_shell(file, skip=MEASURES)
sheet = shell.design.mechanism
crests, valleys = (shell.design.closeness[side].max for side in ("crests", "valleys"))
print(f"crests and valleys within {crests:.3f} m and {valleys:.3f} m of where they should lie")

# %%
# From the flat sheet to the shell, and on to the stack.

figure, frames = plt.subplots(2, 2, figsize=(10, 7), layout="constrained")
drives = [0.3 * sheet.target_drive, 0.7 * sheet.target_drive, sheet.target_drive, 3.0]
for axes, drive in zip(frames.flat, drives, strict=True):
    draw_shell(axes, sheet.positions(drive), camera(-60, 30), line=0.5)
    axes.set_title(f"{drive / 3.1416 * 180:.0f}°")
same_scale(list(frames.flat))

# %%
# The crease pattern.

figure, axes = plt.subplots(figsize=(8, 7), layout="constrained")
draw_pattern(axes, shell.motion.flat.positions, find_assignment(sheet), line=0.9)
