"""The columns of an orthodiagonal sheet: the steps between them, their shape, how fast edges turn.

Edges i and k of a column make the angle phi_ik, the sum of the turns s_l 2 arctan(kappa/T_l)
between them, in every column alike. So the squared distance of two vertices of column j is

    sum_i L_ij^2 + 2 sum_{i<k} L_ij L_kj cos(phi_ik)

over the edges between them, whose lengths L never change.

Bounds of the accelerations of edges prove that nothing touches between states. Edges of columns are
rigid and turn in f's plane; edges of rows are k_j a_i + N_j n, two perpendicular parts, the first
in f's plane (see the mechanism's text). In axes along the edge beyond it a_i has the components
(T_i, -s_i kappa). Both halves of the sheet are followed from the middle row outwards.
"""

from __future__ import annotations

from dataclasses import field

import numpy as np

from orishell.conventions.record import record
from orishell.families.shared.sheets import (
    other_side,
    running_products,
    running_sums,
    target_drive,
)
from orishell.numerics import FUNCTIONS, Enclosure, Interval, spinning_acceleration
from orishell.numerics.arrays import Array, Complex, Integers

SLIM = 1e-13
"""The pack of a sheet of straight rows is taken so near to its end (sine of half an angle)."""


@record
class Columns:
    """Steps over the panel columns (n+1,), flaps at both ends, and the motion that they allow."""

    k: Array  # along K
    locked: Array  # along n at the target: l sin eps, positive but for flaps that fold flat
    existing: slice  # those that are not missing flaps
    step: Array = field(init=False, repr=False)
    """Distances (n+1,) between neighbouring columns in the flat sheet."""
    _tightest: tuple[float, float] = field(init=False, repr=False)
    """Of the tightest panel column's step, the shares along n and along K at the target."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "step", np.hypot(self.locked, self.k))
        step = self.step[self.existing]
        along, across = self.locked[self.existing] / step, np.abs(self.k[self.existing]) / step
        # Nearly straight rows differ in what they take across only, the others along only.
        tightest = int(along.argmin() if along.min() < across.max() else across.argmax())
        object.__setattr__(self, "_tightest", (float(along[tightest]), float(across[tightest])))

    @property
    def rest(self) -> float:
        """The smallest share of a step that is along n at the target: of the tightest columns."""
        return self._tightest[0]

    def phase(self, drive: Array) -> tuple[Array, Array]:
        """Kappa (...) and the distances N (..., n+1) of column planes at drives (...) (radians)."""
        rest, turn = self._tightest
        there = drive == target_drive(rest)
        cosine = np.where(there, rest / np.hypot(1.0, rest), np.cos(drive / 2))
        cosine = np.maximum(cosine, SLIM if rest else 0.0)
        omega = np.hypot(turn, rest * cosine)
        kappa = np.where(there, 1.0, np.sin(drive / 2) / omega)
        closing = cosine[..., None] * np.hypot(rest * self.step, self.k)
        advance = np.hypot(self._fixed, closing) / omega[..., None]
        return kappa, np.where(there[..., None], self.locked, advance)

    def enclosures(self, start: Array, stop: Array) -> tuple[Enclosure, Enclosure]:
        """Kappa (S, 1) and N (S, n+1) over ranges (S, 1) of the drive (radians).

        N is hypot(fixed, u k) over the tightest column's share along K, with u = cos(rho/2)/omega.
        """
        rest, turn = self._tightest
        sine, cosine, omega, cube = self._halves(start, stop)
        swing = cosine.over(omega).squared().times(3 * rest**2)
        lag = sine.over(omega).squared().times(3 * rest**2)
        kappa = Enclosure(
            Interval(sine.low / omega.high, sine.high / omega.low),
            cosine.over(cube),
            sine.over(cube).times(0.5) * swing.plus(-1.0),
        )
        u = Enclosure(
            Interval.between(cosine.low / omega.low, cosine.high / omega.high),
            sine.over(cube).times(-(turn**2)),
            cosine.over(cube).times(-0.5 * turn**2) * lag.plus(1.0),
        )
        share = np.abs(self.k) / (turn or 1.0)
        return kappa, u.times(share).hypot(self._fixed / turn if turn else self.step)

    def _halves(self, start: Array, stop: Array) -> tuple[Interval, Interval, Interval, Interval]:
        """Sine and cosine of rho/2, omega, and 2 omega^3."""
        rest, turn = self._tightest
        cosine = Enclosure.half_cosine(start, stop).value
        omega = cosine.through(lambda ends: np.hypot(turn, rest * ends))
        cube = omega.through(lambda ends: 2 * ends**3)
        return Enclosure.half_sine(start, stop).value, cosine, omega, cube

    def whole_angle(self, start: Array, stop: Array) -> Enclosure:
        """The angle 2 arctan(kappa) (S, 1) over ranges (S, 1) of the drive (radians).

        It is the drive itself where all rows are straight. With s, c the sine and the cosine of
        rho/2 and w = 1/(1 + turn^2 s^2) its derivatives are w c/omega and
        -turn^2 s (1/(2 omega^3) + w c^2/omega) w.
        """
        if (turn := self._tightest[1]) <= SLIM:
            return Enclosure.variable(start, stop)
        sine, cosine, omega, cube = self._halves(start, stop)
        share = Interval(1 / (1 + (turn * sine.high) ** 2), 1 / (1 + (turn * sine.low) ** 2))
        bend = cosine.squared().over(omega) * share + Interval(1 / cube.high, 1 / cube.low)
        return Enclosure(
            Interval(2 * np.arctan2(sine.low, omega.high), 2 * np.arctan2(sine.high, omega.low)),
            Interval(cosine.low / omega.low, cosine.high / omega.high) * share,
            sine.times(-(turn**2)) * share * bend,
        )

    @property
    def _fixed(self) -> Array:
        """What of omega N (n+1,) does not change; from whichever of its two forms loses less."""
        rest, turn = self._tightest
        whole, part = (self.locked, rest * self.step)
        if rest > turn:
            whole, part = turn * self.step, np.abs(self.k)
        return other_side(whole, part)


def column_and_spread(
    kappa: Array, tangents: Array, turning: Array, lengths: Array, trims: tuple[float, float]
) -> tuple[Complex, Complex]:
    """P (..., m+2) from the middle vertex, and a (..., m+2) less its middle value.

    In complex numbers whose real axis is the middle row's t. The outermost rows continue a
    column's end edges, trimmed. ``tangents`` and ``turning`` (m,) are T = tan(beta/2) and the
    signs of the turns.
    """
    kappa = kappa[..., None]
    middle = len(tangents) // 2
    half = tangents + 1j * (turning * kappa)
    half /= np.hypot(half.real, half.imag)
    turn = half * half
    after = half[..., middle, None] * running_products(turn[..., middle + 1 :])
    before = half[..., middle, None] * running_products(turn[..., :middle][..., ::-1])
    direction = np.concatenate([before[..., ::-1].conj(), after], axis=-1)
    column = running_sums(lengths * direction, middle + 1)

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

    whole: The angle 2 arctan(kappa) (S, 1).
    lengths: Edge lengths of the columns of the pairs (P, m+1), none negative.
    rows: Rows of the two vertices of every pair (P, 2).
    """
    edge = np.arange(lengths.shape[1])
    between = (edge >= rows.min(axis=1)[:, None]) & (edge < rows.max(axis=1)[:, None])
    spanned = np.where(between, lengths, 0.0)
    i, k = np.triu_indices(lengths.shape[1], 1)
    weights = 2 * spanned[:, i] * spanned[:, k]

    # Sums of intervals between two edges: differences of running sums of their ends.
    turns = _turns(whole, tangents).times(turning).running()
    angles = turns.each(lambda sums: sums.through(lambda ends: ends[:, k] - ends[:, i]))
    cosines = FUNCTIONS["cos"].of(angles)
    products = cosines.each(lambda each: each.through(lambda ends: ends @ weights.T))
    return products.plus((spanned**2).sum(axis=1))


def _turns(whole: Enclosure, tangents: Array) -> Enclosure:
    """Turns 2 arctan(kappa/T) (S, m) at vertices of these T: a half turn where kappa is infinite.

    With y = 2 arctan(kappa) and s, c the sine and the cosine of y/2 the derivatives by y are
    g = T/(T^2 c^2 + s^2) and (T^2 - 1) s c g^2/T.
    """
    y = whole.value
    sine = Enclosure.half_sine(y.low, y.high).value
    cosine = Enclosure.half_cosine(y.low, y.high).value
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
    """Bounds of the second derivative of edge vectors by the drive: along rows, down columns.

    drives: Ends (S,) of ranges of the drive.
    tilt_rate: Angle by which f's plane turns in itself per drive.
    lengths: Lengths (m+1,) of the longest edges between two rows.
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
