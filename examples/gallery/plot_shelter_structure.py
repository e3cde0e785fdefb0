"""
Does the shelter stand
======================

The :doc:`shelter of boards <plot_shelter_boards>` under its own weight, snow of 0.5 kN on every
square metre of ground and wind of 26 m/s, across it and along it
(``examples/shelter_structure.toml``). Its feet are anchored. Loads are combined with factors like
those of EN 1990. You choose these factors and the pressure coefficients of the wind; the program
has none from a code. This is linear analysis for early design. It does not replace an engineer's
check.

.. live:: shelter_structure
"""

import runpy
from dataclasses import replace

from drawing import EXAMPLES, show_loaded

from orishell.cli.structure import summarize_structure
from orishell.design_file import read_design_file
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES

example = runpy.run_path(str(EXAMPLES / "shelter_structure.py"))
design, judge, row = (example[name] for name in ("design", "judge", "row"))
with_creases, on_the_ground = (example[name] for name in ("with_creases", "on_the_ground"))

# %%
# **Boards of 10 mm twin-wall fail.** With free creases they are far too soft in a storm. With rigid
# ones the shell buckles under a fiftieth of it. Displacements of metres only show that linear
# analysis ended long before.

file = read_design_file(EXAMPLES / "shelter_structure.toml")
boards = make_shell(file, skip=["remedies"])  # stronger panels follow below
show_loaded(boards)

# %%
# This is what ``orishell structure`` prints; ``--out`` writes it as a page, ``structure.html``.
# Buckling governs, under the storm across the shelter. The crease with the largest moment is near
# the lee gable in the storm along it, between panels 7,10 and 8,10. Ties carry nothing while
# feet are anchored.

report = boards.report.structure
assert report is not None
print("\n".join(summarize_structure(report, "m", [])))

# %%
# Which panels carry it? The same shelter with other panels and rigid creases should have
# displacements below 5 % of the height, a buckling factor of at least 3, and a utilisation below 1
# in every case.

print(example["HEAD"])
print(row("twin-wall, 10 mm, the kit", judge(boards, with_creases(boards))))
shells = {panel: design(panel) for panel in example["PANELS"][1:]}
rigid = {panel: judge(shell, with_creases(shell)) for panel, shell in shells.items()}
for panel, found in rigid.items():
    print(row(panel.name, found))

# %%
# Plywood of 15 mm carries it, and so does a light sandwich of glass fibre on foam. Values come from
# makers' sheets and handbooks, rounded down (``examples/shelter_structure.py``). Plates have no
# set-backs here. A bundle of 72 plates of 15 mm is at least 1.1 m thick.
#
# But creases must not turn. The table varies their stiffness, in N m per metre and radian. A strip
# of that plywood 0.1 m wide has 2e4, so straps or battens have to lock the hinges once the shell is
# open.

plywood = shells[example["PLYWOOD"]]
asked = plywood.file.structure.replace_unchecked(crease_stiffness=(2e4, 2e4))
strapped = make_shell(
    replace(plywood.file, structure=asked),
    clash="unexamined",
    skip=(*MEASURES, "stock"),
)
print(example["HEAD"].replace("rigid creases", "plywood, 15 mm"))
for stiffness in (0.0, 1e4):
    found = judge(plywood, with_creases(plywood, stiffness))
    print(row(f"creases of {stiffness:g}", found))
print(row("creases of 20000", judge(strapped, strapped.analysis)))
print(row("rigid creases", rigid[example["PLYWOOD"]]))

# %%
# With cells half as large the plywood shelter with rigid creases is displaced by 2.5 % more, its
# buckling factor is 2 % less, its utilisation 11 % more. The largest stresses are at corners of
# panels, where they have no limit: details there need more than a model of plates.
#
# The plywood shelter with creases of 2e4 under its loads, and what governs it.

show_loaded(strapped)
report = strapped.report.structure
assert report is not None
print("\n".join(summarize_structure(report, "m", [])))

# %%
# **Without anchors** it does not stay: the wind's uplift exceeds its weight and carries it off.
# Under snow alone ties work, on smooth ground with the whole thrust, most of all the first one, at
# a gable. With a coefficient of friction of 0.3 feet would need three times the friction they have,
# so they slip until ties carry nearly as much.

for case in on_the_ground(plywood, 0.0).cases:
    found = case.equilibrium
    answer = f"stands, ties bear {found.tie_forces.max():.0f} N" if found else "is carried off"
    print(f"{case.name}: {answer}")
