"""When a polyline is too coarse for its curve to be recognised."""

from __future__ import annotations

from orishell.curves import Trace
from orishell.geometry import rise

COARSE_SHARE = 0.1
"""A polyline that leaves g by more than this share of g's rise draws a warning."""


def warn_of_coarse_row(trace: Trace, distance: float, columns: int) -> tuple[str, ...]:
    """Warn of a polyline that steps over the shape of g.

    Parameters
    ----------
    trace
        The curve g.
    distance
        Distance of the polyline from it, in its unit.
    columns
        Number n of the polyline's vertices.
    """
    size = rise(trace.points)
    if distance <= COARSE_SHARE * size + 1e-9 * trace.length:
        return ()
    return (
        f"the polyline of g with {columns} columns leaves g by {distance:.4g}, "
        f"{distance / size:.0%} of g's rise of {size:.4g} (more than {COARSE_SHARE:.0%}): "
        "the shell will not show g's shape; take more columns",
    )
