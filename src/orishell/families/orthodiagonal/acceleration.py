"""Bounds of the accelerations of edges, which prove that nothing touches between states.

Edges of columns are rigid and turn in f's plane; edges of rows are k_j a_i + N_j n, two
perpendicular parts, the first in f's plane (see the mechanism's text). In axes along the edge
beyond it a_i has the components (T_i, -s_i kappa). Both halves of the sheet are followed from the
middle row outwards.
"""

from __future__ import annotations

import numpy as np

from orishell.families.orthodiagonal.columns import Columns
from orishell.numerics import Enclosure, spinning_acceleration
from orishell.numerics.arrays import Array


def bound_edges(
    drives: tuple[Array, Array],
    *,
    tangents: Array,
    turning: Array,
    trims: tuple[float, float],
    tilt_rate: float,
    lengths: Array,
    columns: Columns,
) -> tuple[Array, Array]:
    """Bounds of the second derivative of edge vectors by the drive.

    Parameters
    ----------
    drives
        Ends (S,) of ranges of the drive (radians).
    tangents
        T = tan(beta/2) of the rows (m,).
    turning
        Sign of their turns (m,).
    trims
        Growth by K of the first and of the last edge of a column.
    tilt_rate
        Angle by which f's plane turns in itself per drive.
    lengths
        Lengths (m+1,) of the longest edges between two rows.
    columns
        Steps over the panel columns.

    Returns
    -------
    tuple
        Along rows (S, n+1), down columns (S, m+1): length per radian squared.
    """
    start, stop = (ends[..., None] for ends in drives)
    kappa, advance = columns.enclosures(start, stop)
    middle = len(tangents) // 2
    # Seen from behind, the first half turns and tilts the other way.
    above, rising = _outwards(
        kappa, tangents[middle::-1], turning[middle::-1], -trims[0], -tilt_rate
    )
    below, falling = _outwards(kappa, tangents[middle:], turning[middle:], trims[1], tilt_rate)
    down = lengths * np.concatenate([above[..., ::-1], below], axis=-1)
    in_plane = np.maximum(rising, falling) * np.abs(columns.k[columns.existing])
    across = advance.second.magnitude()[..., columns.existing]
    return np.hypot(in_plane, across), np.asarray(down)


def _outwards(
    kappa: Enclosure, tangents: Array, turning: Array, trim: float, rate: float
) -> tuple[Array, Array]:
    """Bounds for unit vectors along the edges (S, K) beyond the rows (K,), for all a (S, 1)."""
    half = kappa.arctan2(tangents)
    share = np.where(np.arange(len(tangents)) == 0, 1.0, 2.0)
    angle = half.times(share * turning).running().part(slice(1, None))
    angle = Enclosure(angle.value, angle.first.plus(rate), angle.second)
    sideways = kappa.times(-turning)
    rows = _swung(angle, tangents, sideways)
    last = slice(-1, None)
    border = _swung(angle.part(last), tangents[last] + trim, sideways.part(last))
    return spinning_acceleration(angle), np.maximum(rows.max(axis=-1, keepdims=True), border)


def _swung(angle: Enclosure, forwards: Array, sideways: Enclosure) -> Array:
    """Bound for a planar vector of these components in axes turned by an angle."""
    centripetal = angle.first.squared()
    along = (
        centripetal.times(-forwards)
        - (angle.first * sideways.first).times(2.0)
        - angle.second * sideways.value
    )
    across = sideways.second + angle.second.times(forwards) - centripetal * sideways.value
    return np.hypot(along.magnitude(), across.magnitude())
