"""Many pieces as one curve, evaluated together.

Pieces of the same kind are held in the same arrays, so that thousands of them cost no more than
one function evaluated at as many parameters.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import comb
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from orishell.curves.curve import Curve
from orishell.curves.jets import Array
from orishell.curves.pieces import Arc, Bezier, Piece

Integers = NDArray[np.intp]

RETRACTED = 1e-6
"""A control point this near to the end, relative to the control polygon, is put on it."""
SLOWEST = (1e-8, 1e-5)
"""Nearest to the end with a retracted control point that first and second derivatives are taken:
there the second derivative is infinite in the end itself."""
SLUGGISH = 0.2
"""A piece that is slower than this at both ends, relative to its mean, is sampled in the middle."""


class _Group(Protocol):
    def jet(self, row: Integers, s: Array) -> tuple[Array, Array, Array]: ...


@dataclass(frozen=True, slots=True, eq=False)
class PieceArrays:
    """Pieces, grouped by kind.

    Parameters
    ----------
    groups
        Pieces of one kind each.
    group, row
        Which group each piece (N,) is in, and where in it.
    """

    groups: tuple[_Group, ...]
    group: Integers
    row: Integers
    lengths: Array = field(init=False)
    """Arc lengths (N,), to a few digits: they set the pace of the parameter."""

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
            add(np.array([k for k, _ in arcs]), _Arcs.of([arc for _, arc in arcs]))
        straight: list[tuple[Integers, Array]] = []
        by_degree: dict[int, list[int]] = {}
        for k, piece in enumerate(pieces):
            if isinstance(piece, Bezier):
                by_degree.setdefault(len(piece.control) - 1, []).append(k)
        for degree in sorted(by_degree, reverse=True):
            members = np.array(by_degree[degree])
            control = np.stack([_control(pieces[k]) for k in members])
            if degree > 1:
                control, line, slow = _even_out(control)
                straight.append((members[line], control[line][:, [0, -1]]))
                bent = ~line
                add(members[bent], _Rationals(_powers(control[bent]), slow[bent]))
            else:
                straight.append((members, control))
        if straight:
            members = np.concatenate([each for each, _ in straight])
            ends = np.concatenate([each for _, each in straight])
            ends = ends / ends[:, :, 2:]
            add(members, _Rationals(_powers(ends), np.zeros(len(ends), np.intp)))
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

    def at(self, share: float) -> Array:
        """The point (N, 2) at the same share of every piece."""
        count = len(self.group)
        return self.jet(np.arange(count), np.full(count, share))[0]


def curve_from_pieces(arrays: PieceArrays, joints: Array) -> Curve:
    """One curve from pieces in their order.

    Parameters
    ----------
    arrays
        The pieces (N,), each from one joint to the next.
    joints
        Where they meet (N+1, 2): what little their ends are off is spread along each piece.

    Returns
    -------
    Curve
        Its parameter is about the arc length. Every joint is one of its ``breaks``: what is no
        corner there does no harm, and samples then stand where the curvature jumps.
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

    every = np.arange(len(lengths))
    ends = [np.hypot(*arrays.jet(every, np.full(len(lengths), s))[1].T) for s in (0.0, 1.0)]
    sluggish = np.maximum(*ends) < SLUGGISH * lengths
    middles = 0.5 * (knots[:-1] + knots[1:])[sluggish]
    breaks = np.union1d(knots[1:-1], middles)
    inside = (breaks > 0.0) & (breaks < knots[-1])
    return Curve(jet, 0.0, float(knots[-1]), tuple(breaks[inside].tolist()))


@dataclass(frozen=True, slots=True, eq=False)
class _Rationals:
    """Rational Bezier curves of one degree, as powers of s.

    Parameters
    ----------
    powers
        Coefficients (N, degree + 1, 3) of weight times x, weight times y, and weight.
    slow
        -1 or 1 where the control point next to the beginning or the end is retracted into it.
    """

    powers: Array
    slow: Integers

    def jet(self, row: Integers, s: Array) -> tuple[Array, Array, Array]:
        if not self.slow.any():
            return self._jet(row, s)
        # There the curve goes like the square of its parameter: take the square as parameter.
        side = self.slow[row]
        root = np.where(side < 0, np.sqrt(s), np.sqrt(np.maximum(1 - s, 0.0)))
        inner = [
            np.where(side == 0, s, np.where(side < 0, clipped, 1 - clipped))
            for clipped in (root, *(np.maximum(root, least) for least in SLOWEST))
        ]
        pace = np.where(side == 0, 1.0, 0.5 / np.maximum(root, SLOWEST[0]))
        even = np.where(side == 0, 1.0, 0.5 / np.maximum(root, SLOWEST[1]))
        bend = np.where(side == 0, 0.0, side * 2 * even**3)
        position = self._jet(row, inner[0])[0]
        first = self._jet(row, inner[1])[1] * pace[:, None]
        _, by_s, twice = self._jet(row, inner[2])
        return position, first, twice * (even**2)[:, None] + by_s * bend[:, None]

    def _jet(self, row: Integers, s: Array) -> tuple[Array, Array, Array]:
        powers = self.powers[row]
        s = s[:, None]
        value = powers[:, -1]
        first = second = np.zeros_like(value)
        for k in range(powers.shape[1] - 2, -1, -1):
            second = second * s + 2 * first
            first = first * s + value
            value = value * s + powers[:, k]
        weight = value[:, 2:]
        position = value[:, :2] / weight
        speed = (first[:, :2] - position * first[:, 2:]) / weight
        bend = (second[:, :2] - 2 * speed * first[:, 2:] - position * second[:, 2:]) / weight
        return position, speed, bend


@dataclass(frozen=True, slots=True, eq=False)
class _Arcs:
    """Elliptical arcs: centres (N, 2), axes (N, 2, 2), first angles and sweeps (N,)."""

    centre: Array
    axes: Array
    start: Array
    sweep: Array

    @classmethod
    def of(cls, arcs: Sequence[Arc]) -> _Arcs:
        return cls(
            np.array([arc.centre for arc in arcs]),
            np.array([arc.axes for arc in arcs]),
            np.array([arc.start for arc in arcs]),
            np.array([arc.sweep for arc in arcs]),
        )

    def jet(self, row: Integers, s: Array) -> tuple[Array, Array, Array]:
        sweep = self.sweep[row][:, None]
        angle = self.start[row][:, None] + s[:, None] * sweep
        cos, sin = np.cos(angle), np.sin(angle)
        u, v = self.axes[row, 0], self.axes[row, 1]
        out = cos * u + sin * v
        return self.centre[row] + out, sweep * (cos * v - sin * u), -sweep * sweep * out


def _control(piece: Piece) -> Array:
    assert isinstance(piece, Bezier)
    return piece.control


def _powers(control: Array) -> Array:
    """Coefficients (N, d+1, 3) of powers, from those of Bernstein's polynomials."""
    degree = control.shape[1] - 1
    powers, differences = [], control
    for k in range(degree + 1):
        powers.append(comb(degree, k) * differences[:, 0])
        differences = np.diff(differences, axis=1)
    return np.stack(powers, axis=1)


def _even_out(control: Array) -> tuple[Array, NDArray[np.bool_], Integers]:
    """Find curves (N, d+1, 3) that stand still in an end because control points lie in it.

    Returns
    -------
    tuple
        The control points, those near an end put into it; whether a curve is a straight line
        because all lie in its ends; -1 or 1 where one lies in its beginning or end.
    """
    points = control[:, :, :2] / control[:, :, 2:]
    steps = np.diff(points, axis=1)
    near = RETRACTED * np.hypot(steps[..., 0], steps[..., 1]).sum(axis=1)
    control = control.copy()
    counts = []
    for end, order in ((0, slice(None)), (-1, slice(None, None, -1))):
        away = points - points[:, end, None]
        close = np.hypot(away[..., 0], away[..., 1]) <= near[:, None]
        run = np.logical_and.accumulate(close[:, order], axis=1)
        there = run[:, order]
        snapped = points[:, end, None] * control[:, :, 2:]
        control[:, :, :2] = np.where(there[..., None], snapped, control[:, :, :2])
        counts.append(run.sum(axis=1))
    line = counts[0] + counts[1] >= control.shape[1]
    slow = np.where(counts[0] == 2, -1, 0) + np.where(counts[1] == 2, 1, 0)
    return control, line, np.where(line, 0, slow)
