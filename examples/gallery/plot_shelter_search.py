"""
Which shelter is best
=====================

A shelter should be light, small when it travels, and stiff under snow; none is all of that.
``examples/shelter_search.toml`` lists what may change in a shelter of plywood on fabric hinges: the
thickness of its panels, the depth of its folds and the number of its rows. Three figures should be
small: mass, packed volume and the largest displacement under snow of 0.5 kN per square metre, which
is at most 60 mm. No shelter may buckle or break. ``orishell search`` takes minutes for this. Its
shelters are kept in ``examples/shelter_search/journal.jsonl`` and looked up here.
:doc:`/guide/searching` says how it is done.

.. live:: shelter_search
"""

import runpy
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib.pyplot as plt
from drawing import EXAMPLES, LOCKED, camera, draw_shell, same_scale

from orishell.search import alone, read_problem
from orishell.search.evaluate import reasons
from orishell.search.front import costs
from orishell.search.write import draw_front

example = runpy.run_path(str(EXAMPLES / "shelter_search.py"))
find, chosen, design, row = (example[name] for name in ("find", "chosen", "design", "row"))

problem = read_problem(EXAMPLES / "shelter_search.toml")
with alone() as pool:
    found = find(problem, pool)
print(f"{len(found.outcomes)} shelters, {len(found.front.members)} that no other beats")
for reason, count in reasons(problem, found.outcomes):
    print(f"{count}: {reason}")

# %%
# The blue shelters are not beaten in all three figures at once. A shelter that seems to be beaten
# in one picture is not beaten in another.

with TemporaryDirectory() as directory:
    path = Path(directory) / "front.png"
    draw_front(path, problem, found)
    picture = plt.imread(path)
height, width = picture.shape[:2]
_, axes = plt.subplots(figsize=(14, 14 * height / width), layout="constrained")
axes.imshow(picture)
axes.axis("off")

# %%
# The ends of the front, its knee, and the shelter that the search began with.

picked = chosen(problem, found)
print(example["HEAD"])
for name, outcome in picked.items():
    print(row(problem, name, outcome))
for name in ("stiffest", "smallest pack"):
    words = costs(problem, picked["knee"], picked[name])
    print(f"from the knee to the {name}:\n  {words}")

# %%
# Their shells at the target, to one scale. The stiffest has a ridge along its crown, the one that
# packs smallest a valley. Rows and depth decide which of two zigzags the shell takes; the search
# did not ask for either. At the same mass a ridge deflects far less, and packs larger: that is the
# leap in the picture of mass and deflection. A leap in a front is worth such a look.

shown = {name: picked[name] for name in ("smallest pack", "knee", "stiffest")}
figure, frames = plt.subplots(1, len(shown), figsize=(13, 4.2), layout="constrained")
for axes, (name, outcome) in zip(frames, shown.items(), strict=True):
    sheet = design(problem, outcome).design.mechanism
    draw_shell(axes, sheet.positions(LOCKED * sheet.target_drive), camera(-40, 24), line=0.5)
    axes.set_title(f"{name}: {outcome.figures['mass']:.0f} kg")
same_scale(list(frames))
