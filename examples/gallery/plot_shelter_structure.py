"""
Does the shelter stand
======================

The :doc:`shelter of boards <plot_shelter_boards>` under its own weight, snow of 0.5 kN on every
square metre of ground and wind of 26 m/s, across it and along it
(``examples/shelter_structure.toml``). Its feet are anchored. Loads are combined with factors like
those of EN 1990; these, and the pressure coefficients of the wind, are for the user to say: the
program has no code's. The answer is linear theory, a first design that signs nothing.

.. live:: shelter_structure
"""

import runpy
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib.pyplot as plt
from drawing import EXAMPLES

from orishell import Shell
from orishell.cli.structure import summarize_structure
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from orishell.structure.files import draw_structure

example = runpy.run_path(str(EXAMPLES / "shelter_structure.py"))
design, judge, row = (example[name] for name in ("design", "judge", "row"))
with_creases, on_the_ground = (example[name] for name in ("with_creases", "on_the_ground"))


def show(shell: Shell) -> None:
    """The shell under its loads, as ``structure.png`` has it."""
    assert shell.document.loaded is not None
    assert shell.analysis is not None
    with TemporaryDirectory() as directory:
        path = Path(directory) / "structure.png"
        draw_structure(path, shell.document.loaded, shell.analysis, "m")
        picture = plt.imread(path)
    height, width = picture.shape[:2]
    _, axes = plt.subplots(figsize=(12, 12 * height / width), layout="constrained")
    axes.imshow(picture)
    axes.axis("off")


# %%
# **Boards of 10 mm twin-wall do not carry it.** With free creases they are far too soft in a storm;
# with rigid ones the shell buckles under a fiftieth of it. The figures of metres only say that
# linear theory ended long before.

boards = design()
show(boards)

# %%
# What ``orishell structure`` prints of it; ``--out`` writes that as a page, ``structure.html``.
# What governs is buckling, under the storm across the shelter. The crease that bears most is one
# near the lee gable in the storm along it, between panels [7, 10] and [8, 10]. Ties have nothing to
# do while feet are anchored.

report = boards.report.structure
print("\n".join(summarize_structure(report, "m", [])))

# %%
# What carries it, then? The same shelter of other panels, with rigid creases: displacements below 5
# % of the height, a buckling factor of at least 3, and less than all of the strength in every case.

print(example["HEAD"])
print(row("twin-wall, 10 mm, the kit", judge(boards, with_creases(boards))))
for panel in example["PANELS"]:
    shell = design(panel)
    print(row(panel.name, judge(shell, with_creases(shell))))

# %%
# Plywood of 15 mm does, and a light sandwich of glass fibre on foam. Values are of makers' sheets
# and handbooks, rounded down (``examples/shelter_structure.py``). Plates are taken without
# set-backs. A bundle of 72 plates of 15 mm is at least 1.1 m thick.
#
# But creases must not turn. How stiff they must be, in N m per metre and radian: 2e4 is what a
# strip of that plywood 0.1 m wide has, so hinges have to be locked by straps or battens once the
# shell is open.

plywood = design(example["PLYWOOD"])
print(example["HEAD"].replace("rigid creases", "plywood, 15 mm"))
for stiffness in (0.0, 1e3, 1e4, 2e4, float("inf")):
    found = judge(plywood, with_creases(plywood, stiffness))
    print(row(f"creases of {stiffness:g}", found))

# %%
# Cells half as large change displacements by 1 to 6 % and buckling factors by up to a tenth; the
# largest stresses nearly double: they are at corners of panels, where they have no limit, and say
# little. A detail there needs more than plates.

print(row("rigid, twice the cells", judge(plywood, with_creases(plywood, cells=8))))

# %%
# Where the plywood shelter bears most: the picture of its loads, and what governs.

asked = plywood.file.structure.having(crease_stiffness=(2e4, 2e4))
shell = make_shell(
    replace(plywood.file, structure=asked),
    clash="unexamined",
    skip=(*MEASURES, "stock"),
)
show(shell)
report = shell.report.structure
assert report is not None
print("\n".join(summarize_structure(report, "m", [])))

# %%
# **Not anchored** it does not stay: wind lifts more than it weighs, and carries it off. Under snow
# alone ties do their work, on smooth ground all of it: the first one, at a gable, most. On ground
# with a coefficient of friction of 0.3 feet would have to stick with three times of what they have,
# so they slip until ties bear nearly as much.

for case in on_the_ground(plywood, 0.0).cases:
    found = case.stands
    answer = f"stands, ties bear {found.tie_forces.max():.0f} N" if found else "is carried off"
    print(f"{case.name}: {answer}")
