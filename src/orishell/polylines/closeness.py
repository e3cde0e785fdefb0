"""How close a polyline and a curve are."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from orishell.curves import Trace
from orishell.curves.jets import Array
from orishell.curves.nearest import Nearest
from orishell.geometry import distances_to_polyline
from orishell.polylines.thinning import thinned

SAMPLES_PER_EDGE = 8


@dataclass(frozen=True, slots=True)
class Closeness:
    """Distances between a curve and a polyline, in the unit of their coordinates.

    Parameters
    ----------
    max
        The Hausdorff distance: the largest distance of a point of either to the other.
    rms
        Root mean square over the curve's length of the distance to the polyline.
    """

    max: float
    rms: float


def measure_closeness(trace: Trace, vertices: Array) -> Closeness:
    """Measure a polyline (K, 2) against a curve, both ways.

    The curve is taken at the samples of its trace, 20,000 to 40,000 of them where there are more,
    the polyline at its vertices and :data:`SAMPLES_PER_EDGE` points on every edge.

    Parameters
    ----------
    trace
        The curve.
    vertices
        Vertices (K, 2) of the polyline.
    """
    nearest, trace = Nearest.to(trace), thinned(trace)
    to_polyline = distances_to_polyline(trace.points, vertices)
    part = np.arange(SAMPLES_PER_EDGE)[:, None, None] / SAMPLES_PER_EDGE
    along = (vertices[:-1] * (1 - part) + vertices[1:] * part).reshape(-1, 2)
    _, to_curve = nearest(np.concatenate([along, vertices[-1:]]))
    squares = to_polyline**2
    mean = float((0.5 * (squares[1:] + squares[:-1]) * np.diff(trace.arc)).sum() / trace.length)
    return Closeness(float(max(to_polyline.max(), to_curve.max())), float(np.sqrt(mean)))
