"""The trade-off picture: distance from the surface against number of panels."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from orishell.plot.scene import DPI

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
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    from matplotlib.layout_engine import ConstrainedLayoutEngine
    from matplotlib.ticker import StrMethodFormatter

    layout = ConstrainedLayoutEngine(h_pad=0.1, w_pad=0.1)
    figure = Figure(figsize=(8.0, 5.2), facecolor="white", layout=layout)
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    panels, errors, _ = zip(*tried, strict=True)
    axes.plot(panels, errors, "o-", color=LINE, markersize=4, linewidth=1, label="designs tried")
    last = 0.0
    for count, error, name in tried:
        if count > APART * last:
            axes.annotate(
                name, (count, error), xytext=(5, 5), textcoords="offset points", color=LINE
            )
            last = count
    axes.axhline(tolerance, color=LIMIT, linestyle="--", label=f"tolerance {tolerance:g} {unit}")
    axes.plot(*chosen[:2], "o", color=CHOSEN, markersize=9, label=f"chosen: {chosen[2]}")
    axes.set_xscale("log")
    axes.set_yscale("log")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axes.set_xlabel("panels, flaps left out")
    axes.set_ylabel(f"largest distance between shell and surface ({unit})")
    axes.set_title("Fewest panels for a distance from the surface")
    axes.grid(visible=True, which="both", color="#e4e4e4", linewidth=0.6)
    axes.legend(loc="upper right", frameon=False)
    figure.savefig(path, dpi=DPI, metadata={"Software": None})
