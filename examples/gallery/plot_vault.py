"""
A growing vault
===============

Circular sections whose radius grows along the vault: ``examples/vault.toml``, of the third family.
No flaps lock it. Its supports hold it where its first section meets f; without them it would roll
on until its rims touch.

.. live:: vault
"""

import math

import matplotlib.pyplot as plt
from drawing import EXAMPLES, camera, draw_pattern, draw_shell, same_scale

from orishell.conventions.colours import LIGHT
from orishell.design_file import read_design_file
from orishell.motion import find_assignment
from orishell.shell.make import make_shell

file = read_design_file(EXAMPLES / "vault.toml")
shell = make_shell(file)
sheet = shell.design.mechanism
lock = shell.report.lock
print(f"meets f at {math.degrees(lock.target_drive):.3f} degrees")
assert lock.first_contact is not None
first = math.degrees(lock.first_contact.drive)
print(f"first contact at {first:.3f} degrees: {lock.first_contact.kind}")

# %%
# From flat to f. All row creases fold the same way, which rolls the sheet up.

figure, frames = plt.subplots(2, 2, figsize=(10, 6), layout="constrained")
for axes, share in zip(frames.flat, (0.0, 0.35, 0.7, 1.0), strict=True):
    draw_shell(axes, sheet.positions(share * sheet.target_drive), camera(-62, 24))
    axes.set_title(f"{share:.0%}")
same_scale(list(frames.flat))

# %%
# Sections of all columns, along the vault: each a polygon close to a circle.

figure, axes = plt.subplots(figsize=(6, 3.6), layout="constrained")
sections = shell.motion.target.positions[:, sheet.inner_columns, 1:]
for k in range(sections.shape[1]):
    axes.plot(*sections[:, k].T, ".-", color="0.5", alpha=1 - 0.06 * k, linewidth=0.9)
axes.plot(*shell.design.targets["f"][:, 1:].T, color=LIGHT["curve-f"], linewidth=2, label="f")
axes.set_aspect("equal")
axes.axis("off")
axes.legend(loc="upper right", frameon=False)

# %%
# The crease pattern: F rows and S rows alternate, columns repeat every four.

figure, axes = plt.subplots(figsize=(8, 6), layout="constrained")
draw_pattern(axes, shell.motion.flat.positions, find_assignment(sheet))
