"""The shape of a column in f's plane, see the mechanism's text: its vertices and their distances.

Edges i and k of a column make the angle phi_ik, the sum of the turns s_l 2 arctan(kappa/T_l)
between them, in every column alike. So the squared distance of two vertices of column j is

    sum_i L_ij^2 + 2 sum_{i<k} L_ij L_kj cos(phi_ik)

over the edges between them, whose lengths L never change.
"""

from __future__ import annotations

import numpy as np

from orishell.numerics import FUNCTIONS, Enclosure, Interval
from orishell.numerics.arrays import Array, Complex, Integers


def column_and_spread(
    kappa: Array, tangents: Array, turning: Array, lengths: Array, trims: tuple[float, float]
) -> tuple[Complex, Complex]:
    """P (..., m+2) from the middle vertex, and a (..., m+2) less its middle value.

    In complex numbers whose real axis is the middle row's t. The outermost rows continue a
    column's end edges, trimmed.

    Parameters
    ----------
    kappa
        Of every state (...).
    tangents, turning
        T = tan(beta/2) and the signs of the turns (m,).
    lengths
        Edge lengths of column 1 (m+1,), in the unit of the curves.
    trims
        Growth by K of the first and of the last edge of a column.
    """
    kappa = kappa[..., None]
    middle = len(tangents) // 2
    half = tangents + 1j * (turning * kappa)
    half /= np.hypot(half.real, half.imag)
    turn = half * half
    after = half[..., middle, None] * _product(turn[..., middle + 1 :])
    before = half[..., middle, None] * _product(turn[..., :middle][..., ::-1])
    direction = np.concatenate([before[..., ::-1].conj(), after], axis=-1)
    edges = lengths * direction
    column = np.concatenate(
        [
            -np.cumsum(edges[..., : middle + 1][..., ::-1], axis=-1)[..., ::-1],
            np.zeros((*edges.shape[:-1], 1)),
            np.cumsum(edges[..., middle + 1 :], axis=-1),
        ],
        axis=-1,
    )

    spread = direction[..., 1:] * (tangents - 1j * (turning * kappa))
    spread -= np.hypot(tangents[middle], kappa)
    spread[..., middle] = 0.0
    first = spread[..., :1] - trims[0] * direction[..., :1]
    last = spread[..., -1:] + trims[1] * direction[..., -1:]
    return column, np.concatenate([first, spread, last], axis=-1)


def squared_distances(
    whole: Enclosure, tangents: Array, turning: Array, lengths: Array, rows: Integers
) -> Enclosure:
    """Squared distances (S, P) of pairs of vertices, each pair in one column.

    Parameters
    ----------
    whole
        The angle 2 arctan(kappa) (S, 1).
    tangents, turning
        T = tan(beta/2) and the signs of the turns (m,).
    lengths
        Edge lengths of the columns of the pairs (P, m+1), none negative.
    rows
        Rows of the two vertices of every pair (P, 2).
    """
    edge = np.arange(lengths.shape[1])
    between = (edge >= rows.min(axis=1)[:, None]) & (edge < rows.max(axis=1)[:, None])
    spanned = np.where(between, lengths, 0.0)
    i, k = np.triu_indices(lengths.shape[1], 1)
    weights = 2 * spanned[:, i] * spanned[:, k]

    # Sums of intervals between two edges: differences of running sums of their ends.
    turns = _turns(whole, tangents).times(turning).running()
    angles = turns.each(lambda sums: sums.through(lambda ends: ends[:, k] - ends[:, i]))
    cosines = FUNCTIONS["cos"](angles.value).of(angles)
    products = cosines.each(lambda each: each.through(lambda ends: ends @ weights.T))
    return products.plus((spanned**2).sum(axis=1))


def _turns(whole: Enclosure, tangents: Array) -> Enclosure:
    """Turns 2 arctan(kappa/T) (S, m) at vertices of these T: a half turn where kappa is infinite.

    With y = 2 arctan(kappa) and s, c the sine and the cosine of y/2 the derivatives by y are
    g = T/(T^2 c^2 + s^2) and (T^2 - 1) s c g^2/T.
    """
    y = whole.value
    sine, cosine = (
        each(y.low, y.high).value for each in (Enclosure.half_sine, Enclosure.half_cosine)
    )
    ends = [
        tangents / ((tangents * c) ** 2 + s**2)
        for s, c in ((sine.low, cosine.high), (sine.high, cosine.low))
    ]
    slope = Interval.between(*ends)
    outer = Enclosure(
        Interval(
            2 * np.arctan2(sine.low, tangents * cosine.high),
            2 * np.arctan2(sine.high, tangents * cosine.low),
        ),
        slope,
        (sine * cosine * slope.squared()).times(tangents - 1 / tangents),
    )
    return outer.of(whole)


def _product(turns: Complex) -> Complex:
    """Running products (..., K+1) of numbers (..., K) of modulus 1, beginning with 1."""
    ones = np.ones((*turns.shape[:-1], 1), dtype=np.complex128)
    return np.asarray(np.concatenate([ones, np.cumprod(turns, axis=-1)], axis=-1))
