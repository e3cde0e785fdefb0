"""Graphs: trade-offs of designs, own weight along the motion, loads against displacements."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from io import BytesIO
from itertools import combinations
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.colours import LIGHT
from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.plot.scene import DPI, GRID, new_chart, save_chart

if TYPE_CHECKING:
    from matplotlib.axes import Axes

DECADE = 10.0
APART = 1.5
"""A design is labelled if it has this many times the panels of the last labelled one."""
LINE, CHOSEN, LIMIT = "#1f5fbf", "#d62728", "#0a8f3c"


def plot_tradeoff(
    path: Path,
    tried: Sequence[tuple[int, float, str]],
    chosen: tuple[int, float, str],
    tolerance: float,
    unit: str,
) -> None:
    """Write the trade-off picture as PNG.

    Parameters
    ----------
    tried
        Number of panels, distance from the surface and name of designs, none beaten in both.
    chosen
        The same of the design that was chosen.
    tolerance
        The distance asked for.
    unit
        Unit of length.
    """
    from matplotlib.ticker import LogFormatter, StrMethodFormatter

    figure = new_chart()
    axes = figure.add_subplot()
    panels, errors, _ = zip(*tried, strict=True)
    axes.plot(panels, errors, "o-", color=LINE, markersize=4, linewidth=1, label="designs tried")
    last = 0.0
    for count, error, name in tried:
        if count > APART * last:
            # Below on the left nothing is drawn: designs with fewer panels are farther away.
            axes.annotate(
                name,
                (count, error),
                xytext=(-5, -4),
                textcoords="offset points",
                color=LINE,
                ha="right",
                va="top",
            )
            last = count
    axes.axhline(tolerance, color=LIMIT, linestyle="--", label=f"tolerance {tolerance:g} {unit}")
    axes.plot(*chosen[:2], "o", color=CHOSEN, markersize=9, label=f"chosen: {chosen[2]}")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.margins(0.12)  # the name of the first design is as wide
    for axis, shown in ((axes.xaxis, axes.get_xlim()), (axes.yaxis, axes.get_ylim())):
        axis.set_major_formatter(StrMethodFormatter("{x:g}"))
        narrow = (
            shown[1] < DECADE * shown[0]
        )  # at most one power of ten is in view: others are said
        axis.set_minor_formatter(StrMethodFormatter("{x:g}") if narrow else LogFormatter())
    axes.set_xlabel("panels (without flaps)")
    axes.set_ylabel(f"largest distance between shell and surface ({unit})")
    axes.set_title("Fewest panels for a distance from the surface")
    axes.grid(which="both", **GRID)
    axes.legend(loc="upper right", frameon=False)
    save_chart(figure, path)


BEATEN, FRONT, KNEE, BEGUN = "#b9b9b9", "#1f5fbf", "#d62728", "#0a8f3c"
SIDE = 4.6
"""Width and height of a pair (inches)."""
ACROSS = 3
"""Pairs beside each other."""


def plot_front(
    path: Path,
    front: Array,
    beaten: Array,
    begun_with: Array,
    *,
    knee: int,
    labels: Sequence[str],
) -> None:
    """Write the picture as PNG.

    front, beaten, begun_with: Designs that no other beats, feasible ones that others beat, and that
        with which the search began, if it can be made: (designs, objectives) each.
    knee: Which of the front is its knee.
    labels: The objectives.
    """
    if len(labels) == 1:  # nothing to set it against: a line of designs
        labels = [*labels, ""]
        front, beaten, begun_with = (
            np.column_stack([each, np.zeros(len(each))]) for each in (front, beaten, begun_with)
        )
    pairs = list(combinations(range(len(labels)), 2))
    across = min(len(pairs), ACROSS)
    down = -(-len(pairs) // across)
    figure = new_chart((SIDE * across + 0.6, SIDE * down + 0.6))
    for k, pair in enumerate(pairs):
        axes = figure.add_subplot(down, across, k + 1)
        _draw_pair(axes, *(each[:, pair] for each in (front, beaten, begun_with)), knee=knee)
        axes.set_xlabel(labels[pair[0]], parse_math=False)
        axes.set_ylabel(labels[pair[1]], parse_math=False)
        if not labels[pair[1]]:
            axes.set_yticks([])
    handles, words = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, words, loc="outside upper center", ncols=2 * across, frameon=False)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # letters that the font lacks
        save_chart(figure, path)


def _draw_pair(axes: Axes, front: Array, beaten: Array, begun_with: Array, *, knee: int) -> None:
    """Designs by two objectives, (designs, 2) each."""

    def dots(points: Array, label: str, colour: str, size: float, mark: str = "o") -> None:
        if len(points):
            x, y = points.T
            axes.scatter(x, y, s=size, marker=mark, color=colour, label=label, linewidths=0)

    dots(beaten, "others beat these", BEATEN, 10)
    dots(begun_with, "the design to begin with", BEGUN, 60, "s")
    dots(front, "no other beats these", FRONT, 26)
    dots(front[knee : knee + 1], "knee", KNEE, 60)
    axes.grid(**GRID)
    axes.set_axisbelow(True)


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


COLOURS = ("#1f5fbf", "#d6815a", "#0a8f3c", "#803a63", "#7db3c0", "#8a6d1d")


@record
class DrawnPath:
    """The path of a load case as it is drawn."""

    name: str  # the load case
    factors: Sequence[float]  # of its loads, point by point
    displacements: Sequence[float]  # the largest at each point
    linear: float  # by linear theory, under the full load


def draw_load_paths(drawn: Sequence[DrawnPath], *, unit: str) -> bytes:
    """Loads against displacements as PNG, linear theory as dashed lines.

    Parameters
    ----------
    drawn
        The paths, in the order of the legend.
    unit
        Unit of length.
    """
    figure = new_chart()
    axes = figure.add_subplot()
    widest = max((max(each.displacements) for each in drawn), default=0.0)
    for number, each in enumerate(drawn):
        colour = COLOURS[number % len(COLOURS)]
        axes.plot(
            each.displacements, each.factors, "o-", color=colour, markersize=3.5, linewidth=1.3,
            label=each.name,
        )  # fmt: skip
        shown = min(1.0, 1.2 * widest / each.linear) if each.linear else 1.0
        axes.plot(
            [0, shown * each.linear], [0, shown], "--", color=colour, linewidth=0.8,
            label=None if number else "linear theory",
        )  # fmt: skip
    axes.axhline(1.0, color="#4a4d55", linewidth=0.8, linestyle=":")
    axes.set_xlabel(f"largest displacement ({unit})")
    axes.set_ylabel("share of the loads")
    axes.set_title("Load against displacement")
    axes.grid(**GRID)
    axes.legend(loc="lower right", frameon=False)
    drawing = BytesIO()
    figure.savefig(drawing, format="png", dpi=DPI, metadata={"Software": None})
    return drawing.getvalue()
