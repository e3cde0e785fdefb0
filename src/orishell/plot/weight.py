"""The picture of own weight: the force at the feet along the motion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.colours import LIGHT
from orishell.plot.scene import GRID, new_chart, save_chart

if TYPE_CHECKING:
    from matplotlib.axes import Axes

OPENS, CLOSES = LIGHT["valley"], LIGHT["mountain"]
CHART_LINE, TIPS = LIGHT["border-crease"], LIGHT["contact"]
MARKS = {"target": LIGHT["target"], "pack": LIGHT["unfolded"]}


@dataclass(frozen=True, slots=True)
class DrawnWeight:
    """The force at the feet along a motion, as it is drawn."""

    drives_deg: Sequence[float]  # drive angles from flat to the pack (degrees)
    # the force by which the feet push outwards there; None where none holds the shell
    forces: Sequence[float | None]
    unit: str  # its unit, in words
    largest: float  # forces up to this size are shown
    # drive angles of the "target" and, if there is one, of the "pack"
    marked_deg: Mapping[str, float]
    tipping_deg: Sequence[float]  # drive angles at which the shell falls to either side


def plot_weight(path: Path, weight: DrawnWeight) -> None:
    """Write the picture of own weight as PNG."""
    figure = new_chart()
    draw_weight(figure.add_subplot(), weight)
    figure.legend(loc="outside lower center", ncols=2, frameon=False)
    save_chart(figure, path)


def draw_weight(axes: Axes, weight: DrawnWeight) -> None:
    """Draw the force at the feet along a motion, without a legend.

    Parameters
    ----------
    axes
        Where to.
    """
    drives, force = np.array(weight.drives_deg), np.array(weight.forces, dtype=float)
    shown = np.nan_to_num(force)
    opens = "opens under its own weight: the feet are held together"
    closes = "closes under its own weight: the feet are held apart"
    for side, colour, words in ((shown > 0, OPENS, opens), (shown < 0, CLOSES, closes)):
        if side.any():
            axes.fill_between(
                drives, shown, where=side, interpolate=True, color=colour, alpha=0.2, label=words
            )
    axes.plot(drives, force, color=CHART_LINE, linewidth=1.4)
    axes.axhline(0, color=CHART_LINE, linewidth=0.8)
    for name, drive in weight.marked_deg.items():
        axes.axvline(drive, color=MARKS[name], linewidth=1.8, label=f"{name}, {drive:.4g}°")
    for k, drive in enumerate(weight.tipping_deg):
        words = "falls to either side" if k == 0 else "_"
        axes.plot(drive, 0, "o", color=TIPS, markersize=8, label=words, zorder=3)
    low, high = np.clip([shown.min(), shown.max()], -weight.largest, weight.largest)
    margin = 0.1 * weight.largest
    axes.set(
        xlim=(-0.02 * drives[-1], 1.02 * drives[-1]),
        ylim=(min(low, 0) - margin, max(high, 0) + margin),
        xlabel="drive (degrees); 0 is the flat sheet, which no force at the feet lifts",
        ylabel=f"outward force at each line of feet ({weight.unit})",
        title="Own weight along the deployment",
    )
    axes.grid(**GRID)
