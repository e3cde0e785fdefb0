"""
A shelter with box girders
==========================

The :doc:`shelter of boards <plot_shelter_boards>` with closed cells
(``examples/shelter_boxes.toml``): two more strips of panels close each of its five valleys to a
tube, and move along with the sheet, which still folds in one motion. Once it stands, twenty plates
are put across the tubes: each of them stops it closing and opening.

.. live:: shelter_boxes
"""

import matplotlib.pyplot as plt
import numpy as np
from drawing import EXAMPLES

from orishell.design_file import read_design_file
from orishell.shell.make import make_shell

shell = make_shell(read_design_file(EXAMPLES / "shelter_boxes.toml"))
for row in shell.report.verdict:
    if row.subject in {"girders", "locks", "packs", "air"}:
        print(f"{row.subject}: {row.finding}")

# %%
# What the tubes hold on the way from the pack, at the right, to where they are joined to the sheet,
# and the pressure of air that balances the shell's own weight. Where they hold most, air has no
# lever: there it comes to rest, and ties or hands do what is left of the way.

air = shell.report.deployment.air
assert air is not None
drives = np.rad2deg(air.drives)
figure, (above, below) = plt.subplots(2, 1, figsize=(8, 6), sharex=True, layout="constrained")
above.plot(drives, air.volumes)
above.set(ylabel="volume (m³)", ylim=(0, None))
pressures = np.array(air.pressures, dtype=float)
pressures[np.abs(pressures) > 1000] = np.nan
below.plot(drives, pressures)
below.set(xlabel="drive (degrees); 0 is the flat sheet", ylabel="pressure (Pa)")
for axes in (above, below):
    axes.axvline(np.rad2deg(shell.lock.target_drive), color="0.5", linewidth=1)
    axes.axvline(np.rad2deg(air.rest), color="0.5", linewidth=1, linestyle="--")
    axes.grid(alpha=0.3)
above.set_title("target (line), and where air rests (dashed)")
