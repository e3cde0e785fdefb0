"""What the pages of fitted shells share."""

from __future__ import annotations

import matplotlib.pyplot as plt
import numpy as np
from drawing import EXAMPLES, draw_shell, same_scale

from orishell import Shell
from orishell.design_file import read_design_file
from orishell.plot.scene import Camera
from orishell.shell.make import make_shell

NEARLY_FLAT = 3.0
"""Drive at which the stack is drawn (radians)."""


def fitted(name: str) -> Shell:
    """The shell of an example that is fitted to a surface."""
    return make_shell(read_design_file(EXAMPLES / f"{name}.toml"))


def draw_to_stack(shell: Shell, view: Camera) -> None:
    """Four states of a shell on its way from the flat sheet over its target to the stack."""
    sheet = shell.design.mechanism
    target = sheet.target_drive
    _, frames = plt.subplots(2, 2, figsize=(10, 7), layout="constrained")
    drives = 0.3 * target, 0.7 * target, target, NEARLY_FLAT
    for axes, drive in zip(frames.flat, drives, strict=True):
        draw_shell(axes, sheet.positions(drive), view, line=0.5)
        axes.set_title(f"{np.rad2deg(drive):.0f}°")
    same_scale(list(frames.flat))
