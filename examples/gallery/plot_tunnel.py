"""
A covered way round a bend
==========================

A ridged section swept along a circle of 8 m: ``examples/tunnel.toml``, parallel repeating. In
this family the rows of a locked shell are level for any g, so it stands on even ground.

.. live:: tunnel
"""

import math

import matplotlib.pyplot as plt
from drawing import EXAMPLES, LOCKED, camera, draw_pattern, draw_shell, same_scale

from orishell.design_file import read_design_file
from orishell.motion import find_assignment
from orishell.shell.make import make_shell

file = read_design_file(EXAMPLES / "tunnel.toml")
shell = make_shell(file)
sheet = shell.design.mechanism
lock = shell.lock
print(f"lock: {lock.cause} at {math.degrees(lock.drive or math.nan)} degrees")

# %%
# It bends while it folds: the flat sheet turns by sin(ξ/2) of the angle by which g turns.

figure, frames = plt.subplots(1, 3, figsize=(12, 4), layout="constrained")
for axes, share in zip(frames, (0.0, 0.55, LOCKED), strict=True):
    draw_shell(axes, sheet.positions(share * sheet.target_drive), camera(-100, 34), line=0.5)
    axes.set_title(f"{180 * share:.0f}°")
same_scale(list(frames))

# %%
# The locked tunnel, seen from its inner side.

figure, axes = plt.subplots(figsize=(9, 5.4), layout="constrained")
draw_shell(axes, sheet.positions(LOCKED * sheet.target_drive), camera(-155, 16))

# %%
# The crease pattern.

figure, axes = plt.subplots(figsize=(7, 6), layout="constrained")
draw_pattern(axes, shell.motion.flat.positions, find_assignment(sheet), line=0.9)
