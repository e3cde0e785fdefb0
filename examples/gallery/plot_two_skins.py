"""
A hall with two skins
=====================

An outer skin that follows f, and an inner one that follows a curve of its own
(``examples/two_skins.toml``), joined by walls. All of it is one mechanism: both skins, the walls
and the cells between them fold with the one motion of the sheet.

.. live:: two_skins
"""

import matplotlib.pyplot as plt
import numpy as np
from drawing import EXAMPLES

from orishell.design_file import read_design_file
from orishell.shell.make import make_shell

shell = make_shell(read_design_file(EXAMPLES / "two_skins.toml"))
for row in shell.report.verdict:
    if row.subject in {"skin", "folds", "boards"}:
        print(f"{row.subject}: {row.finding}")

# %%
# Column 1 from where the skins are joined to beyond the target: edges of both have the same two
# directions in every state. At the target the curve of the inner skin is dashed; its staircase
# leaves it by as much to both sides.

COLOURS = {"sheet": "#333333", "skin": "#2b6cb0", "wall": "#b4413c"}
sheet = shell.design.mechanism
strips = [("sheet", sheet), *((part.kind, part.strips) for part in shell.design.carried)]
shares = {"joined": 0.5, "target": 1.0, "beyond it": 1.2}
figure, frames = plt.subplots(1, 3, figsize=(13, 3.4), layout="constrained", sharey=True)
for axes, (name, share) in zip(frames, shares.items(), strict=True):
    drive = share * sheet.target_drive
    points = sheet.positions(drive)[:, 0]
    middle, along = points.mean(axis=0), points[-1] - points[0]
    along /= np.linalg.norm(along)
    for kind, each in reversed(strips):
        line = each.positions(drive)[:, 0] - middle
        axes.plot(line @ along, line[:, 2], color=COLOURS[kind], linewidth=1.6)
    axes.set_title(f"{name}, {np.rad2deg(drive):.0f}°")
    axes.set_aspect("equal")
    axes.set_axis_off()

file = shell.file
assert file.inner is not None
curves = [
    curve.position(np.linspace(curve.start, curve.stop, 200)) for curve in (file.f, file.inner)
]
outer = sheet.positions(sheet.target_drive)[:, 0]
middle, along = outer.mean(axis=0), outer[-1] - outer[0]
along /= np.linalg.norm(along)
place = np.array([(outer[0] - middle) @ along, outer[0, 2] - middle[2]]) - curves[0][0]
for curve, kind in zip(curves, ("sheet", "skin"), strict=True):
    frames[1].plot(*(curve + place).T, color=COLOURS[kind], linewidth=1, linestyle="--")

# %%
# What the cells hold on the way, if their ends are closed: a fan may blow the hall up.

air = shell.report.deployment.air
assert air is not None
figure, axes = plt.subplots(figsize=(8, 3), layout="constrained")
axes.plot(np.rad2deg(air.drives), air.volumes)
axes.set(xlabel="drive (degrees)", ylabel="volume (m³)", ylim=(0, None))
axes.grid(alpha=0.3)

# %%
# Straight below: a greenhouse in strips whose vertices lie on the curve, its second skin on upright
# walls (``examples/two_skinned_vault.toml``, T-hedral). Both skins are there in every state.
#
# .. live:: two_skinned_vault

vault = make_shell(read_design_file(EXAMPLES / "two_skinned_vault.toml"))
for row in vault.report.verdict:
    if row.subject in {"skin", "folds"}:
        print(f"{row.subject}: {row.finding}")
