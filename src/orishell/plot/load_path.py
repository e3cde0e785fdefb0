"""The picture of loads against displacements, where large displacements are followed."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO

from orishell.conventions.record import record
from orishell.plot.scene import DPI, GRID, new_chart

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
