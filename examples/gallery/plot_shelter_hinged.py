"""
The shelter of whole boards on hinges
=====================================

The :doc:`shelter <plot_shelter>` of 10 mm boards that reach up to their creases
(``examples/shelter_hinged.toml``). Its sheet folds flat, so ordinary hinges can stand beside the
creases, above valleys and below mountains, and all boards still fold together, by the angles of the
sheet without a thickness. That no boards and no arms meet is proved, from the pack over the target
to the flat sheet.

.. live:: shelter_hinged
"""

import matplotlib.pyplot as plt
import numpy as np
from drawing import EXAMPLES

from orishell.design_file import read_design_file
from orishell.shell.designed import designed
from orishell.solids.hinged import board_offsets

design = designed(read_design_file(EXAMPLES / "shelter_hinged.toml"))
hinges, sheet = design.hinges, design.mechanism
assert hinges is not None
print(f"longest arm: {1000 * hinges.longest_arm:.0f} mm")

# %%
# Heights of the hinges down the first two columns, over the middle of the boards. Rows lie on the
# faces, 5 mm over it or below it. Columns stand off them, for the boards of all rows fold in
# between.

figure, axes = plt.subplots(figsize=(8, 4), layout="constrained")
rows = 1 + np.arange(hinges.heights.column.shape[0])
for column in (0, 1):
    heights = 1000 * hinges.heights.column[:, column]
    axes.bar(rows + 0.4 * column - 0.2, heights, width=0.4, label=f"column {column + 1}")
axes.axhspan(-5, 5, color="0.8", label="boards")
axes.set(xlabel="row of boards", ylabel="height of the hinge (mm)")
axes.legend()

# %%
# Boards lie beside the sheet without a thickness, farther the more they are folded. In the flat
# sheet they lie on it. So its edges were made longer or shorter, until the boards, not the sheet,
# meet the target: there they lie in the planes of the panels that would meet it.

drives = np.linspace(0.0, np.pi, 60)
offsets = [1000 * board_offsets(hinges, sheet.positions(drive)) for drive in drives]
figure, axes = plt.subplots(figsize=(8, 4), layout="constrained")
axes.plot(np.rad2deg(drives), [each.max() for each in offsets], label="largest")
axes.plot(np.rad2deg(drives), [np.sqrt((each**2).mean()) for each in offsets], label="r.m.s.")
axes.axvline(np.rad2deg(sheet.target_drive), color="0.6", linestyle=":", label="target")
axes.set(xlabel="drive (degrees)", ylabel="distance (mm)", ylim=(0, None))
axes.legend()

fitted = sheet.positions(sheet.target_drive)
at_target = 1000 * board_offsets(hinges, fitted, design.meant)
print(f"from the panels at the target: {np.sqrt((at_target**2).mean()):.1f} mm r.m.s.")
