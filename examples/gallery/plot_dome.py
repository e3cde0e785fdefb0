"""
A dome that folds flat
======================

A part of a sphere over a square, of boards on a membrane: ``examples/dome.toml``, flat-foldable.
Its pack is a stack of panels, as thick as the boards that lie on each other.

.. live:: dome
"""

import matplotlib.pyplot as plt
from drawing import EXAMPLES, camera, draw_pattern
from fitted import draw_to_stack, fitted

from orishell.design_file import read_design_file
from orishell.motion import find_assignment
from orishell.shell.make import make_shell

shell = fitted("dome")
crests, valleys = (shell.design.closeness[side].max for side in ("crests", "valleys"))
print(f"crests and valleys within {crests:.3f} m and {valleys:.3f} m of where they should lie")

# %%
# From the flat sheet to the shell, and on to the stack.

draw_to_stack(shell, camera(-50, 28))

# %%
# The crease pattern.

figure, axes = plt.subplots(figsize=(8, 7), layout="constrained")
draw_pattern(axes, shell.motion.flat.positions, find_assignment(shell.design.mechanism), line=0.9)

# %%
# Locked: ``examples/dome_locked.toml`` is the same dome with flaps, two at either end of every row.
# Their boards bear on each other at the target, and stop it there.
#
# .. live:: dome_locked

locked = make_shell(read_design_file(EXAMPLES / "dome_locked.toml"))
width = locked.design.parameters["flap"]
print(f"flaps {width:.2f} m wide; what ends the motion: {locked.lock.cause}")
