"""
A shelter for winter
====================

It stands in snow of 1 kN on every square metre of ground and in wind of 25 m/s, in all combinations
of EN 1990, and its hinges turn freely: nothing is locked (``examples/shelter_snow.toml``). Flaps
that are clipped on stop the one motion that the sheet has, ties across its folds what is left.
Deep waves of g make it stiff: feet stand on a zigzag, about which panels cannot turn together.

.. live:: shelter_snow
"""

import matplotlib.pyplot as plt
import numpy as np
from drawing import EXAMPLES, camera, draw_shell, draw_ties, same_scale, show_loaded

from orishell.cli.structure import summarize_structure
from orishell.design_file import read_design_file
from orishell.shell.make import make_shell

shell = make_shell(read_design_file(EXAMPLES / "shelter_snow.toml"))
sheet, deployment = shell.design.mechanism, shell.report.deployment
assert deployment is not None
assert shell.lock is not None
target, pack = sheet.target_drive, shell.lock.closes_to
assert target is not None
print(f"at its target: {shell.report.deployed}")

# %%
# From the pack to the target, where flaps are clipped on and ties are taut. On the way panels do
# not touch, and ties are slack: both are proved.

figure, frames = plt.subplots(1, 4, figsize=(12, 3.4), layout="constrained")
for axes, share in zip(frames, (1.0, 0.5, 0.2, 0.0), strict=True):
    drive = target + share * (pack - target)
    positions, view = sheet.positions(drive), camera(-40, 24)
    draw_shell(axes, positions, view)
    draw_ties(axes, positions, deployment.ties, view)
    axes.set_title(f"{np.rad2deg(drive):.0f}°")
same_scale(list(frames))

# %%
# Under the case that governs, and under the one that moves it most.

show_loaded(shell)

# %%
# This is what ``orishell structure`` prints. Forces along crease lines govern: hinges are bolted
# through what chamfers leave of a board, and what they bear is calculated in the design file.

report = shell.report.structure
assert report is not None
print("\n".join(summarize_structure(report, "m", [])))
