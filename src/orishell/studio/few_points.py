"""Points of a measured curve, few enough to be moved by hand."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import CurveError
from orishell.curves import curve_from_points, trace_curve
from orishell.curves.nearest import Nearest
from orishell.numerics.arrays import Array

MANY = 20
"""So many points are kept as they are."""
CLOSE = 2e-3
"""How far a measured point may be from the spline, relative to the size of the curve."""
FEWEST_POINTS, MOST_POINTS = 5, 40


def few_points(points: Array) -> tuple[Array, bool, float]:
    """Fewer points (N, 2) along a curve, whether it is a spline, and how far it is from them all.

    The spline is fitted by least squares, so that noise is smoothed out; it keeps the ends. Where
    few straight lines do what no spline of few points does, there are corners; where neither does,
    a spline goes through all points.
    """
    import shapely

    if len(points) <= MANY:
        return points, True, 0.0
    size = float(np.hypot(*np.ptp(points, axis=0)))
    for count in range(FEWEST_POINTS, min(MOST_POINTS, len(points) // 2) + 1):
        few = _fitted(points, count)
        try:
            trace = trace_curve(curve_from_points(few, smooth=True))
        except CurveError:
            continue
        farthest = float(Nearest.to(trace)(points)[1].max())
        if farthest <= CLOSE * size:
            return few, True, farthest
    corners = shapely.get_coordinates(shapely.simplify(shapely.linestrings(points), CLOSE * size))
    if len(corners) <= MANY:
        lines = Nearest.to(trace_curve(curve_from_points(corners, smooth=False)))
        return corners, False, float(lines(points)[1].max())
    return points, True, 0.0


def _fitted(points: Array, count: int) -> Array:
    """Points (count, 2) of the cubic spline with so many coefficients that fits best."""
    from scipy.interpolate import make_lsq_spline

    chords = np.hypot(*np.diff(points, axis=0).T)
    apart = np.concatenate([[True], chords > 0])
    along = np.concatenate([[0.0], np.cumsum(chords)])[apart]
    share = along / along[-1]
    inner = np.linspace(0, 1, count - 2)[1:-1]
    knots = np.concatenate([np.zeros(4), inner, np.ones(4)])
    try:
        spline = make_lsq_spline(share, points[apart], knots)
    except (ValueError, np.linalg.LinAlgError):  # no points between two knots
        kept = np.unique(np.rint(np.linspace(0, len(points) - 1, count)).astype(int))
        return np.asarray(points[kept])
    few: Array = spline(np.linspace(0, 1, count))
    few[[0, -1]] = points[[0, -1]]
    places = 5 - int(np.floor(np.log10(np.ptp(points, axis=0).max())))
    rounded: Array = np.round(few, places) + 0.0
    return rounded
