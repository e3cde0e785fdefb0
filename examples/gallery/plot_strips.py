"""
Vertices on the curve
=====================

A vault of twelve strips that are joined by hinges (``examples/strip_vault.toml``, T-hedral). Its
vertices lie on the curve, so that it is smooth along f, and it packs into a flat stack.

.. live:: strip_vault
"""

import matplotlib.pyplot as plt
from drawing import EXAMPLES, camera, draw_shell, same_scale

from orishell.design_file import read_design_file
from orishell.motion.as_made import in_strips
from orishell.shell.make import make_shell

shell = make_shell(read_design_file(EXAMPLES / "strip_vault.toml"))
for row in shell.report.verdict:
    if row.subject in {"folds", "packs", "surface", "sheet"}:
        print(f"{row.subject}: {row.finding}")

# %%
# From the vault to the pack.

sheet = shell.design.mechanism
end = sheet.end_drive
drives = (sheet.target_drive, 0.5 * end, 0.8 * end, 0.97 * end)
figure, frames = plt.subplots(1, 4, figsize=(13, 3.4), layout="constrained")
for axes, drive in zip(frames, drives, strict=True):
    draw_shell(axes, sheet.positions(drive), camera(-58, 26))
same_scale(list(frames))

# %%
# What is cut: strips, each of them flat.

cut = in_strips(sheet)
figure, axes = plt.subplots(figsize=(9, 4.6), layout="constrained")
for first, second in cut.flat[cut.mesh.edges]:
    axes.plot(*zip(first, second, strict=True), color="0.3", linewidth=0.7)
axes.set_aspect("equal")
axes.set_axis_off()

# %%
# About an axis: half a band of a dome, its vertices on the sphere (``examples/strip_dome.toml``).
# Strips are alike, and meet the sphere along its circles of latitude.
#
# .. live:: strip_dome

dome = make_shell(read_design_file(EXAMPLES / "strip_dome.toml"))
assert dome.deviation is not None
print(f"within {1000 * dome.deviation.max:.0f} mm of the sphere")
