"""
A free roof from a mesh
=======================

A mesh as it comes out of a modelling program: ``examples/roof.obj``, a target in
``examples/free_roof.toml``. Four corners of its rim become those of the sheet.

.. live:: free_roof
"""

import matplotlib.pyplot as plt
from drawing import camera, draw_pattern
from fitted import draw_to_stack, fitted

from orishell.motion import find_assignment

shell = fitted("free_roof")
crests, valleys = (shell.design.closeness[side].max for side in ("crests", "valleys"))
print(f"crests and valleys within {crests:.3f} m and {valleys:.3f} m of where they should lie")

# %%
# From the flat sheet to the shell, and on to the stack.

draw_to_stack(shell, camera(-60, 30))

# %%
# The crease pattern.

figure, axes = plt.subplots(figsize=(8, 7), layout="constrained")
draw_pattern(axes, shell.motion.flat.positions, find_assignment(shell.design.mechanism), line=0.9)
