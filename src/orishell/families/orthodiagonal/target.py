"""The target surface, f slid along g, and the surface that finer and finer shells approach."""

from __future__ import annotations

import numpy as np

from orishell.conventions.formatting import in_degrees
from orishell.conventions.quantities import plain
from orishell.curves import Trace, curve_from_points, trace_curve
from orishell.design import Approached, Path, Sliding, Surface
from orishell.families.orthodiagonal.mechanism import Orthodiagonal
from orishell.numerics.arrays import Array
from orishell.polylines import Zigzag

STRAIGHT = 1e-9
"""A g that leaves the columns' normal by less than this share of its length follows it."""


def sweep(f: Trace, zigzag: Zigzag, g: Trace, mechanism: Orthodiagonal) -> Surface:
    """f slid along g, which lies in the plane of the middle row.

    The zigzag passes through g at its middle vertex.
    """
    rail = Sliding(Path.of(g), complex(np.exp(-1j * mechanism.heading)), mechanism.tilt)
    return Surface(f, _origin(zigzag), rail)


def tilted(g: Array, mechanism: Orthodiagonal) -> str:
    """How g's plane is turned in the target surface, in words; empty where that leaves g as it is.

    Parameters
    ----------
    g
        g in that surface (N, 3).
    mechanism
        The sheet.
    """
    high = float(np.ptp(g[:, 2]))
    if high <= STRAIGHT * float(np.ptp(g, axis=0).max()):
        return ""
    return (
        f"g's plane is tilted by {in_degrees(abs(mechanism.tilt))} degrees about the columns' "
        f"normal, as the axis of f's zigzag is: g is {high:.4g} high"
    )


def approach(f: Trace, zigzag: Zigzag, g: Trace, mechanism: Orthodiagonal) -> Approached | None:
    """What the shell approaches: the cylinder over f along the common normal of its columns.

    Rows shift along f, alternately to and fro, by as much as g departs from the normal. The edges
    of the zigzag limit that: the finer it is, the less can g depart.
    """
    t = np.exp(-1j * mechanism.heading)
    normal = 1j * t
    points = g.points @ np.array([1, 1j])
    relative = (points - points[0]) * normal.conjugate()
    leaves = float(np.ptp(relative.imag))
    if leaves < STRAIGHT * g.length:
        return None
    ends = points[0] + np.array([relative.real.min(), relative.real.max()]) * normal
    line = curve_from_points(np.stack([ends.real, ends.imag], axis=-1), smooth=False)
    rail = Sliding(Path.of(trace_curve(line)), complex(t))
    return Approached(
        f"rows shift to and fro along f by as much as g departs from the columns' normal, "
        f"{plain(leaves)}, and the shell keeps to the cylinder over f along that normal",
        Surface(f, _origin(zigzag), rail),
    )


def _origin(zigzag: Zigzag) -> np.ndarray:
    return np.asarray(zigzag.vertices[len(zigzag.vertices) // 2])
