"""The two angles of a staircase: which ones exist, and which ones are best.

``xi`` is the angle between adjacent edges, ``theta`` the rotation of the curve in its plane. A
staircase exists when every tangent of the rotated curve lies within (pi - xi)/2 of the x axis.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from orishell.curves import Trace
from orishell.curves.nearest import Nearest
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_smallest, largest_of
from orishell.polylines.staircase import (
    Search,
    Staircase,
    batched,
    rotated_search,
    run_search,
    search_staircase,
)

MIN_EVENNESS = 0.25
""""auto" keeps the shortest edge above this fraction of the mean (0.5 is usual: the two end edges
overshoot the curve on one side only)."""
WIDEST_XI = np.deg2rad(150.0)
"""The widest angle that "auto" takes: beyond it the corrugation is too shallow to stiffen."""
MARGIN = 1e-4
"""How far "auto" stays inside an open interval, relative to it."""
XI_ACCURACY = 1e-6
"""How near "auto" comes to the widest xi (radians)."""
COARSE_ACCURACY, COARSE_EDGES = 2e-3, 24
"""Accuracy of xi (radians), and edges, while searching theta: the best hardly depends on either."""
WORTHWHILE = 1e-3
""""auto" leaves a curve unrotated unless a rotation brings it closer by this share."""


def xi_limit(low: float, high: float) -> float:
    """The angle below which a staircase exists.

    Parameters
    ----------
    low, high
        Range of the curve's tangent directions, measured from the x axis (radians).

    Returns
    -------
    float
        A staircase exists for every xi in (0, limit); for none if the limit is not positive.
    """
    return float(np.pi - 2 * max(abs(low), abs(high)))


def widest_angle(low: float, high: float) -> float:
    """The widest angle that "auto" may take, whatever the edges' lengths (radians).

    Parameters
    ----------
    low, high
        Range of the curve's tangent directions, measured from the x axis (radians).
    """
    return min(xi_limit(low, high) * (1 - MARGIN), float(WIDEST_XI))


def theta_interval(low: float, high: float, xi: float) -> tuple[float, float]:
    """Rotations theta for which a staircase of angle ``xi`` exists.

    Parameters
    ----------
    low, high
        Range of the unrotated curve's tangent directions (radians).
    xi
        Angle between adjacent edges (radians).

    Returns
    -------
    tuple
        The open interval; empty (first >= second) where the tangents spread over pi - xi or more.
    """
    cone = (np.pi - xi) / 2
    return float(-cone - low), float(cone - high)


def choose_xi(trace: Trace, edges: int, accuracy: float = XI_ACCURACY) -> float:
    """The angle of the closest staircase whose shortest edge is not too short.

    The distance falls as xi opens, so this is the widest admissible xi, at most
    :data:`WIDEST_XI`, whose staircase keeps :data:`MIN_EVENNESS`; where none does, the most even.

    Parameters
    ----------
    trace
        The rotated curve; some staircase must exist.
    edges
        Number of edges.
    accuracy
        How near to come to the widest (radians).
    """
    return run_search(_search_xi(trace, edges, accuracy), Nearest.to(trace)).xi


def _search_xi(trace: Trace, edges: int, accuracy: float) -> Search[Staircase]:
    """The staircase of the angle that :func:`choose_xi` chooses."""
    widest = widest_angle(*trace.heading_range())
    tried: list[Staircase] = []
    for trial in np.linspace(widest, 0.1 * widest, 13):
        tried.append((yield from search_staircase(trace, float(trial), edges)))
        if tried[-1].evenness >= MIN_EVENNESS:
            break
    else:
        return largest_of(tried, lambda staircase: staircase.evenness)  # the widest of equal ones
    good, bad = tried[-1], tried[max(len(tried) - 2, 0)].xi
    # Bisection on the even side: the evenness may jump where another first edge becomes better.
    while bad - good.xi > accuracy:
        middle = yield from search_staircase(trace, 0.5 * (good.xi + bad), edges)
        good, bad = (middle, bad) if middle.evenness >= MIN_EVENNESS else (good, middle.xi)
    return good


def choose_theta(trace: Trace, edges: int, xi: float | None) -> float:
    """The rotation of the closest staircase whose shortest edge is not too short.

    Parameters
    ----------
    trace
        The unrotated curve; some rotation must admit a staircase.
    edges
        Number of edges.
    xi
        The angle between edges (radians), or None to take the best one (:func:`choose_xi`) for
        each theta.
    """
    from scipy.optimize import minimize_scalar

    low, high = trace.heading_range()
    begin, end = theta_interval(low, high, xi if xi is not None else 0.0)
    margin = MARGIN * (end - begin)
    begin, end = begin + margin, end - margin
    coarse = min(edges, COARSE_EDGES)
    nearest = Nearest.to(trace)

    def costs(thetas: Iterable[float], edges: int = coarse) -> Array:
        every = [
            rotated_search(_search_cost(trace.rotated(theta), edges, xi), theta) for theta in thetas
        ]
        return np.array(run_search(batched(every), nearest))

    # The scan is symmetric about the middle, where a symmetric curve has its optimum.
    scan = np.linspace(begin, end, 11)
    k = first_smallest(costs(scan))
    bracket = (float(scan[max(k - 1, 0)]), float(scan[min(k + 1, len(scan) - 1)]))
    found = minimize_scalar(
        lambda theta: float(costs([theta])[0]),
        bounds=bracket,
        method="bounded",
        options={"xatol": 1e-3},
    )
    candidates = [float(scan[k]), float(found.x)]
    if begin < 0 < end:
        candidates.insert(0, 0.0)  # unrotated, unless another rotation is really closer
    finals = costs(candidates, edges)
    return candidates[int(np.argmin(finals > (1 + WORTHWHILE) * finals.min()))]


def _search_cost(rotated: Trace, edges: int, xi: float | None) -> Search[float]:
    """The cost of a rotation: the staircase's distance, far more if its edges are uneven."""
    if xi is None:
        staircase = yield from _search_xi(rotated, edges, COARSE_ACCURACY)
    else:
        staircase = yield from search_staircase(rotated, xi, edges)
    lacking = MIN_EVENNESS - staircase.evenness
    # The size of the curve separates them.
    return staircase.distance if lacking < 1e-6 else rotated.length * (10 + lacking)
