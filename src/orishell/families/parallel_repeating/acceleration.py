"""Bounds of the accelerations of edges, which prove that nothing touches between states.

Edges between rows are combinations of one vector per column and the vertical, edges along rows
are rigid and level; their directions are sums of the angles eps of the mechanism's text.
"""

from __future__ import annotations

import numpy as np

from orishell.families.parallel_repeating.columns import Columns
from orishell.numerics import Enclosure, spinning_acceleration, turning_acceleration
from orishell.numerics.arrays import Array


def bound_edges(
    columns: Columns,
    chords: Array,
    lengths: Array,
    reach: Array,
    drives: tuple[Array, Array],
) -> tuple[Array, Array]:
    """Bounds of the second derivative of edge vectors by the drive.

    Parameters
    ----------
    columns
        Equation (2).
    chords
        Lengths (n-1,) of the middle row's segments.
    lengths
        Lengths (n+1,) of the longest crease between two columns, flaps at both ends.
    reach
        What column 1's edges (m+1,) take along t, per unit of spread, and upwards at the target.
    drives
        Ends (S,) of ranges of the drive (radians).

    Returns
    -------
    tuple
        Along rows (S, n+1), down columns (S, m+1): length per radian squared.
    """
    start, stop = (ends[..., None] for ends in drives)
    size = np.hypot(1.0, columns.rest)
    tight = Enclosure.half_cosine(start, stop).times(size)
    w = tight.hypot(columns.slope_beyond[1:-1])
    right = w.arctan2((columns.tau * columns.cos_right)[:-1])
    left = w.arctan2((columns.tau * columns.cos_left)[1:])
    axis = (right + left).running()
    segment = axis.part(slice(-1)) + right
    mean = segment.mean(chords / chords.sum())
    axis, segment = axis - mean, segment - mean

    outer = columns.tau[[0, -1]] * [columns.cos_left[0], columns.cos_right[-1]]
    flap = tight.hypot(columns.slope_beyond[[0, -1]]).arctan2(outer)
    first = axis.part(slice(1)) - flap.part(slice(1))
    last = axis.part(slice(-1, None)) + flap.part(slice(1, None))
    along = lengths * np.concatenate(
        [spinning_acceleration(angle) for angle in (first, segment, last)], axis=-1
    )
    spread = turning_acceleration(tight.hypot(columns.tau_beyond), axis).max(axis=-1, keepdims=True)
    down = np.hypot(spread * reach, 0.25 * size * np.sin(stop / 2) * reach)
    return along, np.asarray(down)
