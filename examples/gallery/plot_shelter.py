"""
An emergency shelter
====================

A clear floor of 3 m by 6 m, two metres of headroom, level ground: ``examples/shelter.toml``. It is
pulled open from a bundle until its ties are taut. The g of this orthodiagonal shell is a zigzag, so
its columns turn alternately to either side. That stiffens it lengthwise, and joins all its rows in
one motion.

.. live:: shelter
"""

import matplotlib.pyplot as plt
import numpy as np
from drawing import EXAMPLES, camera, draw_pattern, draw_shell, draw_ties, same_scale

from orishell.deployment import smallest_box
from orishell.design_file import read_design_file
from orishell.motion import find_assignment, largest_fold
from orishell.plot import draw_weight
from orishell.shell.make import make_shell
from orishell.shell.pictures import weight_of

shell = make_shell(read_design_file(EXAMPLES / "shelter.toml"))
sheet, pack = shell.design.mechanism, shell.lock.closes_to
deployment = shell.report.deployment
slack = sum(tie.slack is True for tie in deployment.ties)
print(f"at its target: {shell.report.deployed}")
print(f"{slack} ties, proved to be slack from the pack to there")

# %%
# From the pack over the target, where ties are taut, to the flat sheet, in which it is made. No two
# panels touch on the way: that is proved, not sampled.

figure, frames = plt.subplots(2, 3, figsize=(12, 6.4), layout="constrained")
target = np.rad2deg(sheet.target_drive)
for axes, degrees in zip(frames.flat, (178, 165, 130, target, 50, 0), strict=True):
    positions, view = sheet.positions(np.deg2rad(degrees)), camera(-40, 24)
    draw_shell(axes, positions, view)
    if degrees >= target:
        draw_ties(axes, positions, deployment.ties, view)
    axes.set_title(f"{degrees:.0f}°")
same_scale(list(frames.flat))

# %%
# Ties stop the shell opening, and boards clipped on as flaps stop it closing. Its own weight closes
# it at its target with 31 N, which the flaps carry. Without ties it would fall flat if it opened 6
# degrees further: at the point in the picture it tips to either side.

figure, axes = plt.subplots(figsize=(8, 5.2), layout="constrained")
weight = weight_of(deployment, shell.lock)
assert weight is not None
draw_weight(axes, weight)
figure.legend(loc="outside lower center", ncols=2, frameon=False)

# %%
# The pack depends on how far its creases close. Panels have no thickness here. With 10 mm boards
# the 72 layers of the bundle would be at least 0.72 m thick. :doc:`plot_shelter_boards` has the
# design with boards.

drives = np.linspace(sheet.target_drive, pack, 200)
folds = np.rad2deg(largest_fold(sheet, drives))
angles = np.linspace(150, 180, 61)
boxes = [smallest_box(sheet.positions(np.interp(a, folds, drives)).reshape(-1, 3)) for a in angles]
figure, axes = plt.subplots(figsize=(8, 4.4), layout="constrained")
for name in ("length", "width", "height"):
    axes.plot(angles, [getattr(box, name) for box in boxes], label=f"{name} of the smallest box")
axes.axhline(0.72, color="grey", linestyle="--", label="72 boards of 10 mm")
axes.set(xlabel="largest fold angle (degrees)", ylabel="metres", ylim=(0, None))
axes.legend(loc="upper right", frameon=False)

# %%
# The crease pattern. The table ``[workshop]`` cuts it, and the flaps, from boards of 8 by 4 feet.

figure, axes = plt.subplots(figsize=(7, 6.4), layout="constrained")
draw_pattern(axes, shell.motion.flat.positions, find_assignment(sheet))
stock = shell.report.quantities.stock
assert stock is not None
print(f"{stock.sheets} boards, {shell.report.quantities.mass_kg:.0f} kg")
