"""
A ring canopy
=============

A rising profile swept along 300 degrees of a circle: ``examples/canopy.toml``, parallel repeating.
Its sheet is a piece of a ring, too, hardly more than half of one: it winds up as it folds.

.. live:: canopy
"""

import math

import matplotlib.pyplot as plt
from drawing import EXAMPLES, LOCKED, camera, draw_pattern, draw_shell, same_scale

from orishell.design_file import read_design_file
from orishell.motion import find_assignment
from orishell.shell.make import make_shell

file = read_design_file(EXAMPLES / "canopy.toml")
shell = make_shell(file)
sheet = shell.design.mechanism
lock = shell.lock
print(f"lock: {lock.cause} at {math.degrees(lock.drive or math.nan)} degrees")

# %%
# Its ends come round until they face each other across the entrance.

figure, frames = plt.subplots(2, 2, figsize=(10, 6), layout="constrained")
for axes, share in zip(frames.flat, (0.0, 0.4, 0.7, LOCKED), strict=True):
    draw_shell(axes, sheet.positions(share * sheet.target_drive), camera(-20, 32), line=0.5)
    axes.set_title(f"{180 * share:.0f}°")
same_scale(list(frames.flat))

# %%
# The crease pattern.

figure, axes = plt.subplots(figsize=(9, 5.6), layout="constrained")
draw_pattern(axes, shell.motion.flat.positions, find_assignment(sheet), line=0.9)
