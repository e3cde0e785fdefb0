"""
The shelter as a kit of boards
==============================

The :doc:`shelter <plot_shelter>` in panels of 10 mm (``examples/shelter_boards.toml``): two boards
of 4.75 mm twin-wall polypropylene, glued on both faces of a fabric of 0.5 mm. Where a crease
closes, boards stand back from it by 5 mm times the tangent of half its largest fold angle, so
neighbours never cross the plane that bisects the crease. That no other two boards meet is proved,
from the pack over the target to the flat sheet.

.. live:: shelter_boards
"""

import runpy
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from drawing import EXAMPLES, camera, draw_shell, same_scale
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from orishell.deployment import find_pack
from orishell.design import Setback
from orishell.plot.hinge_picture import draw_hinge_section, section_height
from orishell.plot.scene import WIDTH
from orishell.plot.sections import find_hinge_section
from orishell.solids import drive_for_height
from orishell.workshop import Drawing
from orishell.workshop.palettes import load_palette
from orishell.workshop.sheets import draw_sheet_files

kit = runpy.run_path(str(EXAMPLES / "shelter_boards.py"))
shell = kit["design"]()
for name, value in kit["measure"](shell).items():
    print(f"{name}: {value:.4g}")

# %%
# A section through the hinge from which boards stand back farthest, to scale. In the pack, at the
# right, the two boards meet at the plane that bisects it.

document, sheet = shell.document, shell.design.mechanism
assert document.boards is not None
assert document.panel is not None
section = find_hinge_section(shell.motion, document.boards, document.panel)
assert section is not None
figure = plt.figure(figsize=(WIDTH, section_height(section)))
draw_hinge_section(figure, section, "m")

# %%
# The pack that boards allow, where set-backs take half of the way across a panel, and the target.

figure, frames = plt.subplots(1, 2, figsize=(11, 4.6), layout="constrained")
for axes, drive in zip(frames, (shell.lock.closes_to, sheet.target_drive), strict=True):
    draw_shell(axes, sheet.positions(drive), camera(-40, 24))
    axes.set_title(f"{np.rad2deg(drive):.1f}°")
same_scale(list(frames))

# %%
# What limits the pack is how far boards may stand back. Shorter set-backs leave wider boards, and a
# larger pack.

setbacks = np.linspace(0.03, 0.19, 9)
thickness = document.panel.thickness
builds = [
    document.panel.replace_unchecked(largest_setback=Setback(length=each)) for each in setbacks
]
ends = [drive_for_height(sheet, build) for build in builds]
volumes = [find_pack(sheet, end, 3, thickness).box.volume for end in ends]
figure, axes = plt.subplots(figsize=(8, 4), layout="constrained")
axes.plot(1000 * setbacks, volumes, marker="o")
axes.set(xlabel="largest set-back (mm)", ylabel="smallest box (m³)", ylim=(0, None))

# %%
# Layer by layer: the fabric with the places of the upper boards, the upper and the lower boards.
# Flaps are pieces of their own, clipped on at the target.


def show(axes: Axes, drawing: Drawing) -> None:
    """A drawing for a machine, without its words."""
    pens = load_palette("plain").pens
    for line in drawing.lines:
        points = [*line.points, *line.points[: int(line.closed)]]
        axes.plot(*zip(*points, strict=True), color=pens[line.layer].colour, linewidth=0.5)
    axes.set_aspect("equal")
    axes.axis("off")


def drawn(name: str) -> Figure:
    """One of the shell's drawings."""
    figure, axes = plt.subplots(figsize=(9, 9), layout="constrained")
    show(axes, drawings[name])
    return figure


workshop = shell.file.workshop.replace_unchecked(stock=None, title_block=False)
files = draw_sheet_files(Path("pattern.svg"), document, workshop)
drawings = {path.name: drawing for path, drawing in files}
figure = drawn("pattern.svg")

# %%
# The upper boards.

figure = drawn("pattern-top.svg")

# %%
# The lower boards, seen from below.

figure = drawn("pattern-bottom.svg")
