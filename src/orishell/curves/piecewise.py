"""Many pieces as one curve, evaluated together.

Pieces of the same kind are held in the same arrays, so that thousands of them cost no more than
one function evaluated at as many parameters.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field
from typing import Protocol

import numpy as np

from orishell.conventions.record import record
from orishell.curves.curve import Curve
from orishell.curves.piece_groups import Arcs, Rationals, even_out, powers_of
from orishell.curves.pieces import Arc, Bezier, Piece
from orishell.numerics import Enclosure, Interval
from orishell.numerics.arrays import Array, Integers

SLUGGISH = 0.2
"""A piece that is slower than this at both ends, relative to its mean, is sampled in the middle."""


class _Group(Protocol):
    def jet(self, row: Integers, s: Array) -> tuple[Array, Array, Array]: ...

    def enclosure(self, row: Integers, low: Array, high: Array) -> tuple[Enclosure, Enclosure]: ...


@record
class PieceArrays:
    """Pieces, grouped by kind."""

    groups: tuple[_Group, ...]
    # which group each piece (N,) is in, and where in it
    group: Integers
    row: Integers
    # arc lengths (N,), to a few digits: they set the pace of the parameter
    lengths: Array = field(init=False)

    def __post_init__(self) -> None:
        node, weight = np.polynomial.legendre.leggauss(16)
        every = np.repeat(np.arange(len(self.group)), len(node))
        speed = np.hypot(*self.jet(every, np.tile(0.5 * (node + 1), len(self.group)))[1].T)
        object.__setattr__(self, "lengths", speed.reshape(-1, len(node)) @ (0.5 * weight))

    @classmethod
    def of(cls, pieces: Sequence[Piece]) -> PieceArrays:
        """Group pieces by kind; Bezier curves that are straight lines become lines."""
        groups: list[_Group] = []
        group = np.zeros(len(pieces), np.intp)
        row = np.zeros(len(pieces), np.intp)

        def add(members: Integers, made: _Group) -> None:
            if len(members):
                group[members] = len(groups)
                row[members] = np.arange(len(members))
                groups.append(made)

        arcs = [(k, piece) for k, piece in enumerate(pieces) if isinstance(piece, Arc)]
        if arcs:
            add(np.array([k for k, _ in arcs]), Arcs.of([arc for _, arc in arcs]))
        straight: list[tuple[Integers, Array]] = []
        by_degree: dict[int, list[int]] = {}
        for k, piece in enumerate(pieces):
            if isinstance(piece, Bezier):
                by_degree.setdefault(len(piece.control) - 1, []).append(k)
        for degree in sorted(by_degree, reverse=True):
            members = np.array(by_degree[degree])
            control = np.stack([_control(pieces[k]) for k in members])
            if degree > 1:
                control, line, slow = even_out(control)
                straight.append((members[line], control[line][:, [0, -1]]))
                bent = ~line
                add(members[bent], Rationals(powers_of(control[bent]), slow[bent]))
            else:
                straight.append((members, control))
        if straight:
            members = np.concatenate([each for each, _ in straight])
            ends = np.concatenate([each for _, each in straight])
            ends = ends / ends[:, :, 2:]
            add(members, Rationals(powers_of(ends), np.zeros(len(ends), np.intp)))
        return cls(tuple(groups), group, row)

    def jet(self, piece: Integers, s: Array) -> tuple[Array, Array, Array]:
        """Position and two derivatives by s, (P, 2) each, at shares s (P,) of pieces (P,)."""
        group, row = self.group[piece], self.row[piece]
        if len(self.groups) == 1:
            return self.groups[0].jet(row, s)
        out = np.zeros((3, len(s), 2))
        for number, each in enumerate(self.groups):
            at = np.flatnonzero(group == number)
            if len(at):
                for whole, part in zip(out, each.jet(row[at], s[at]), strict=True):
                    whole[at] = part
        return out[0], out[1], out[2]

    def enclosure(self, piece: Integers, low: Array, high: Array) -> tuple[Enclosure, Enclosure]:
        """Bounds of x and y between shares ``low`` and ``high`` (P,) of pieces (P,)."""
        group, row = self.group[piece], self.row[piece]
        if len(self.groups) == 1:
            return self.groups[0].enclosure(row, low, high)
        out = np.zeros((2, 3, 2, len(low)))
        for number, each in enumerate(self.groups):
            at = np.flatnonzero(group == number)
            if len(at):
                axes = each.enclosure(row[at], low[at], high[at])
                for whole, found in zip(out, axes, strict=True):
                    for k, ends in enumerate((found.value, found.first, found.second)):
                        whole[k][:, at] = ends.low, ends.high
        x, y = (Enclosure(*(Interval(*ends) for ends in whole)) for whole in out)
        return x, y

    def at(self, share: float) -> Array:
        """The point (N, 2) at the same share of every piece."""
        count = len(self.group)
        return self.jet(np.arange(count), np.full(count, share))[0]


def curve_from_pieces(arrays: PieceArrays, joints: Array) -> Curve:
    """One curve from pieces (N,) in their order, which meet at joints (N+1, 2).

    What little their ends are off is spread along each piece. The parameter is about the arc
    length. Every joint is one of the ``breaks``: what is no corner there does no harm, and samples
    then stand where the curvature jumps.
    """
    lengths = arrays.lengths
    knots = np.concatenate([[0.0], np.cumsum(lengths)])
    begin = joints[:-1] - arrays.at(0.0)
    gain = joints[1:] - arrays.at(1.0) - begin
    last = len(lengths) - 1

    def jet(t: Array) -> tuple[Array, Array, Array]:
        t = np.asarray(t, dtype=np.float64)
        flat = t.ravel()
        cell = np.clip(np.searchsorted(knots, flat, side="right") - 1, 0, last)
        length = lengths[cell]
        s = (flat - knots[cell]) / length
        position, first, second = arrays.jet(cell, s)
        position = position + begin[cell] + s[:, None] * gain[cell]
        first = (first + gain[cell]) / length[:, None]
        second = second / (length * length)[:, None]
        shape = (*t.shape, 2)
        return position.reshape(shape), first.reshape(shape), second.reshape(shape)

    def enclosure(low: Array, high: Array) -> tuple[Enclosure, Enclosure]:
        cell = np.clip(np.searchsorted(knots, 0.5 * (low + high), side="right") - 1, 0, last)
        length = lengths[cell]
        shares = [np.clip((t - knots[cell]) / length, 0.0, 1.0) for t in (low, high)]
        s = Enclosure.variable(shares[0], shares[1])
        found = []
        for axis, each in enumerate(arrays.enclosure(cell, shares[0], shares[1])):
            drawn = each + s.times(gain[cell, axis])
            found.append(
                Enclosure(
                    drawn.value.plus(begin[cell, axis]),
                    drawn.first.times(1 / length),
                    drawn.second.times(1 / (length * length)),
                )
            )
        return found[0], found[1]

    every = np.arange(len(lengths))
    ends = [np.hypot(*arrays.jet(every, np.full(len(lengths), s))[1].T) for s in (0.0, 1.0)]
    sluggish = np.maximum(*ends) < SLUGGISH * lengths
    middles = 0.5 * (knots[:-1] + knots[1:])[sluggish]
    breaks = np.union1d(knots[1:-1], middles)
    inside = (breaks > 0.0) & (breaks < knots[-1])
    return Curve(jet, enclosure, 0.0, float(knots[-1]), tuple(breaks[inside].tolist()))


def _control(piece: Piece) -> Array:
    assert isinstance(piece, Bezier)
    return piece.control
