"""Target curves as the page draws them."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.curves import Curve, trace_curve
from orishell.io.view import Drawn

DRAWN = 200
"""Points of a curve that are drawn, about."""


def sampled(curve: Curve, name: str) -> Drawn:
    """Points of a curve to be drawn; empty if it cannot be used.

    Parameters
    ----------
    curve
        The curve.
    name
        Which of both it is: "f" or "g".
    """
    try:
        trace = trace_curve(curve, name)
    except InputError:
        return []
    kept = np.unique(np.rint(np.linspace(0, len(trace.points) - 1, DRAWN)).astype(int))
    corners = np.flatnonzero(np.abs(trace.heading - trace.arriving) > 0)
    # The page says how wide and how high the curve is.
    extremes = [*trace.points.argmin(axis=0), *trace.points.argmax(axis=0)]
    points = trace.points[np.unique([*kept, *corners[:DRAWN], *extremes])]
    return [(float(x), float(y)) for x, y in points]
