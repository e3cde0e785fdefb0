"""Distances of two vertices of one column, in closed form (the paper's section 2).

In column j, with kappa and the tightest w of the mechanism's text, they have the square

    reach^2 (tau_j^2 - rest^2 + w^2) + rise^2 kappa^2,

where the edges between them go by ``reach`` along t_j, in units of tau_j, and by ``rise`` upwards
at the target. As kappa^2 + w^2 = 1 + rest^2 that is a constant and

    (reach^2 - rise^2) w^2 = 4 up down w^2,

``up`` and ``down`` being what edges rise and fall at the target: it grows all the way from the pack
to the flat sheet wherever there are edges of both kinds between the two vertices.
"""

from __future__ import annotations

import numpy as np

from orishell.families.parallel_repeating.columns import Columns
from orishell.numerics import Enclosure
from orishell.numerics.arrays import Array, Integers


def squared_distances(
    columns: Columns, edges: Array, rows: Integers, which: Integers, drives: tuple[Array, Array]
) -> Enclosure:
    """Squared distances (S, P) of pairs of vertices, each pair in one column.

    Parameters
    ----------
    columns
        Equation (2).
    edges
        By how much the edges (m+1,) of all columns rise at the target (length).
    rows
        Rows of the two vertices of every pair (P, 2).
    which
        The column (P,) of every pair, counted from 0 at column 1.
    drives
        Ends (S,) of ranges of the drive (radians).
    """
    edge = np.arange(len(edges))
    between = (edge >= rows.min(axis=1)[:, None]) & (edge < rows.max(axis=1)[:, None])
    up, down = ((between * np.maximum(sign * edges, 0.0)).sum(axis=1) for sign in (1, -1))
    reach, rise = up + down, up - down
    size = np.hypot(1.0, columns.rest)
    half_cosine = Enclosure.half_cosine(*(ends[:, None] for ends in drives))
    packed = (reach * columns.tau_beyond[which]) ** 2 + (rise * size) ** 2
    return (half_cosine * half_cosine).times(4 * up * down * size**2).plus(packed)
