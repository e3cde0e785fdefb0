"""Pictures of trade-offs: designs by pairs of numbers, those that no other beats marked."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from itertools import combinations
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from orishell.numerics.arrays import Array
from orishell.plot.scene import GRID, new_chart, save_chart

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
