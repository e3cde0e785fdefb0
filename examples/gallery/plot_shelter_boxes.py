"""
A shelter with box girders
==========================

The :doc:`shelter of boards <plot_shelter_boards>` with closed cells
(``examples/shelter_boxes.toml``): two more strips of panels close each of its five valleys to a
tube, and move along with the sheet, which still folds in one motion. Once it stands, twenty plates
are put across the tubes: each of them stops it closing and opening.

.. live:: shelter_boxes
"""

from collections.abc import Iterator
from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np
from drawing import EXAMPLES, camera, draw_boards, draw_pattern, same_scale
from matplotlib.colors import to_rgb
from numpy.typing import NDArray

from orishell.deployment import Site
from orishell.deployment.feet import find_feet
from orishell.design import Design
from orishell.design.stiffeners import Stiffeners
from orishell.design_file import read_design_file
from orishell.locking import lock_without_clash
from orishell.locking.box_plates import with_box_plates
from orishell.locking.carry import with_carried
from orishell.locking.gussets import with_gussets
from orishell.motion import area_of, find_assignment
from orishell.shell.designed import designed
from orishell.shell.make import make_shell
from orishell.structure.load_settings import LoadCase
from orishell.structure.model import Model
from orishell.structure.settings import Structure, Support
from orishell.structure.solve.active_set import respond

shell = make_shell(read_design_file(EXAMPLES / "shelter_boxes.toml"))
for row in shell.report.verdict:
    if row.subject in {"girders", "locks", "packs", "air"}:
        print(f"{row.subject}: {row.finding}")

# %%
# From the pack, at the left, to where girders come off before the sheet is flattened. What the
# proof says of all states between these is above. Sheet and flaps are pale, girders yellow, plates
# red.

COLOURS = {"sheet": "#e9e2d3", "flap": "#b9b2d6", "girder": "#d9a441", "plate": "#b4413c"}
document = shell.document
there = [
    number
    for number, state in enumerate(document.states)
    if len(document.parts_in(number)) > 1 and state.drive_deg is not None
]
target = document.named["target"]
chosen = [there[0], there[0] + (target - there[0]) // 3, there[0] + 2 * (target - there[0]) // 3]
chosen += [target, there[-1]]
figure, frames = plt.subplots(1, 5, figsize=(14, 2.8), layout="constrained")
for axes, number in zip(frames, chosen, strict=True):
    parts = document.parts_in(number)
    panels = [part.panel_corners(state) for part, state in parts]
    inks = np.array([to_rgb(COLOURS[part.kind]) for part, _ in parts])
    corners = np.concatenate(panels)
    colours = np.repeat(inks, [len(each) for each in panels], axis=0)
    draw_boards(axes, np.stack([corners, corners], axis=1), camera(-40, 24), colours)
    axes.set_title(f"{document.states[number].drive_deg:.1f}°")
same_scale(list(frames))

# %%
# The flat sheet, with the lines that girders hang on, and the girder of row 6 beside it: a flat
# crease pattern of its own.

sheet, box = shell.design.mechanism, shell.design.boxes[2]
figure, frames = plt.subplots(1, 2, figsize=(11, 6), width_ratios=[1, 1], layout="constrained")
for axes, folded in zip(frames, (sheet, box.sleeve), strict=True):
    draw_pattern(axes, folded.positions(0.0), find_assignment(folded))
for each in shell.design.boxes:
    assert each.hung is not None
    for line in each.hung.ends:
        frames[0].plot(*line.T, color=COLOURS["girder"], linewidth=1.6)
frames[0].set_title("sheet, and where girders hang on it")
frames[1].set_title(f"girder of row {box.sleeve.row}")
same_scale(list(frames))

# %%
# Largest displacements under 400 N per square metre of plan, on all of the shell and on half of it,
# at equal mass: boards are as thick as this allows. Hinges turn freely, but where they are locked,
# feet are pinned, all is linear. Metres only say that a shell on free hinges does not stand.

DENSITY, THICKNESS, CELLS = 190.0, 0.010, 4  # of polypropylene; of boards of the stiffened shell
Array = NDArray[np.float64]


def area(design: Design) -> float:
    """Of the sheet, and of all that stiffens it."""
    more = [float(part.areas().sum()) for part in design.attached]
    return area_of(design.mechanism) + sum(more) + sum(area_of(b.sleeve) for b in design.boxes)


def sinks(design: Design, mass: float, *, locked: bool = False) -> Iterator[float]:
    """Largest displacements (mm) under the whole load, and under half of it."""
    thickness = mass / (DENSITY * area(design))
    asked = Structure(
        modulus=273e6,
        poisson=0.4,
        thickness=thickness,
        supports=(Support(at="feet", kind="pinned"),),
        cases=(LoadCase(name="dead", self_weight=True),),
        cells=CELLS,
    )
    model = Model(design, asked, Site("m", find_feet(design), (), DENSITY * thickness), CELLS)
    factorised = model.factorised(np.inf if locked else 0.0)
    facets = model.mesh.facets
    corners = facets.points[facets.triangles]
    sides = corners[:, 1:, :2] - corners[:, :1, :2]
    plan = 0.5 * np.abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])
    beyond = corners[..., 1].mean(axis=1) > np.median(model.stiffened.sheet.facets.points[:, 1])
    for loaded in (plan, plan * beyond):
        forces: Array = np.zeros_like(facets.points)
        np.add.at(forces[:, 2], facets.triangles, -400 / 3 * loaded[:, None])
        response = respond(factorised, factorised.free_loads(forces))
        yield 1e3 * factorised.furthest(response.displacements)


file = read_design_file(EXAMPLES / "shelter.toml").changed({"pattern.flap": 0.0})
bare = replace(designed(file), panel=None)
lock = lock_without_clash(bare)
boxes = Stiffeners(kind="boxes", share=0.95, columns=4)
girders, held = with_carried(bare, lock, boxes, 1e-9, examined=False)
plated = with_box_plates(girders, held, boxes, 1e-9)
clipped = with_gussets(bare, lock, Stiffeners(kind="gussets"), 1e-9)
mass = DENSITY * THICKNESS * area(plated)
found = {
    "creases free": [*sinks(bare, mass)],
    f"{len(clipped.plates)} gussets": [*sinks(clipped, mass)],
    f"girders, {len(plated.attached)} plates": [*sinks(plated, mass)],
    "all creases locked": [*sinks(bare, mass, locked=True)],
}
figure, axes = plt.subplots(figsize=(8, 3.6), layout="constrained")
places, whole = np.arange(len(found)), np.array([*found.values()])
for k, (name, colour) in enumerate([("all of it", "#45285a"), ("half of it", "#d6815a")]):
    bars = axes.barh(places + 0.38 * k - 0.19, whole[:, k], height=0.36, label=name, color=colour)
    axes.bar_label(bars, [f" {each:,.0f}" for each in whole[:, k]])
axes.set_yticks(places, [*found])
axes.invert_yaxis()
axes.set_xscale("log")
axes.set(xlim=(10, 3e4), xlabel=f"largest displacement (mm), {mass:.0f} kg")
axes.legend(title="load on", loc="lower right")

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
