"""
An emergency shelter
====================

A clear floor of 3 m by 6 m, two metres of headroom, level ground: ``examples/shelter.toml``. The g
of this orthodiagonal shell is a zigzag, so that its columns turn to and fro: that stiffens it
lengthwise, and ties all its rows to one motion.
"""

import matplotlib.pyplot as plt
from drawing import EXAMPLES, LOCKED, camera, draw_pattern, draw_shell, same_scale

from orishell.design_file import read_design_file
from orishell.motion import find_assignment
from orishell.shell.make import make_shell

file = read_design_file(EXAMPLES / "shelter.toml")
shell = make_shell(file, measured=False)
sheet = shell.design.mechanism
print(f"deployed: {shell.report.deployed}")
print(f"lock: {shell.report.lock.cause} at {shell.report.lock.drive_deg} degrees")

# %%
# From the flat sheet to the lock. On the way no two panels touch: that is proved, not sampled.

figure, frames = plt.subplots(2, 2, figsize=(10, 6.4), layout="constrained")
for axes, share in zip(frames.flat, (0.0, 0.3, 0.6, LOCKED), strict=True):
    draw_shell(axes, sheet.positions(share * sheet.target_drive), camera(-52, 22))
    axes.set_title(f"{180 * share:.0f}°")
same_scale(list(frames.flat))

# %%
# The crease pattern. It travels as boards of 8 by 4 feet, cut by the table ``[workshop]``, that
# are joined on the ground before the shelter is folded up.

figure, axes = plt.subplots(figsize=(7, 6.4), layout="constrained")
draw_pattern(axes, shell.motion.flat.positions, find_assignment(sheet))
stock = shell.report.quantities.stock
assert stock is not None
print(f"{stock.sheets} boards, {shell.report.quantities.mass_kg:.0f} kg")
