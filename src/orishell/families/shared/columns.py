"""Equation (2): the columns of a T-hedron, and what their motion is bounded by.

The distances of two vertices of one column are known in closed form (the paper's section 2).
In column j, with kappa and the tightest w of the mechanism's text, they have the square

    reach^2 (tau_j^2 - rest^2 + w^2) + rise^2 kappa^2,

where the edges between them go by ``reach`` along t_j, in units of tau_j, and by ``rise`` upwards
at the target. As kappa^2 + w^2 = 1 + rest^2 that is a constant and

    (reach^2 - rise^2) w^2 = 4 up down w^2,

``up`` and ``down`` being what edges rise and fall at the target: it grows all the way from the pack
to the flat sheet wherever there are edges of both kinds between the two vertices.

Bounds of the accelerations of edges prove that nothing touches between states. Edges between rows
are combinations of one vector per column and the vertical, edges along rows are rigid and level;
their directions are sums of the angles eps of the mechanism's text.
"""

from __future__ import annotations

from dataclasses import field

import numpy as np

from orishell.conventions.record import record
from orishell.families.shared.sheets import ALIKE, other_side, running_sums, target_drive
from orishell.numerics import Enclosure, spinning_acceleration, turning_acceleration
from orishell.numerics.arrays import Array, Complex, Integers


@record
class Columns:
    """The quantities of equation (2) at lock, for n columns, n-1 segments and both flaps."""

    tau: Array  # tan(xi_j/2), (n,)
    cos_left: Array  # cosine of the angle between t and the crease to the left, (n,)
    cos_right: Array  # and to the right, (n,)
    slope: Array  # nu of every panel column, (n+1,); the tangent of the stop for flaps
    sines: Array  # sin delta_{2j-1}, (n-1,)
    sines_next: Array  # sin delta_{2j}, (n-1,)
    existing: slice  # the panel columns but for missing flaps
    rest: float = field(init=False)  # the slope of the tightest of those that exist
    slope_beyond: Array = field(init=False)  # sqrt(nu**2 - rest**2) of every panel column, (n+1,)
    tau_beyond: Array = field(init=False)  # sqrt(tau**2 - rest**2) of every column, (n,)

    def __post_init__(self) -> None:
        nearly = int(self.slope[self.existing].argmin()) + self.existing.start
        squares, _ = self._squares_beyond(nearly)
        tightest = int(squares[self.existing].argmin()) + self.existing.start
        squares, lost = self._squares_beyond(tightest)
        rest = float(self.slope[tightest])
        slope = np.sqrt(np.where(squares > lost, squares, 0.0))
        slope = np.where(self.slope > 2 * rest, other_side(self.slope, rest), slope)
        # The same from both of its creases; those to the right of the last column may not exist.
        tau = np.hypot(self.tau * self.cos_right, slope[1:])
        tau[-1] = np.hypot(self.tau[-1] * self.cos_left[-1], slope[-2])
        tau = np.where(self.tau > 2 * rest, other_side(self.tau, rest), tau)
        object.__setattr__(self, "rest", rest)
        object.__setattr__(self, "slope_beyond", slope)
        object.__setattr__(self, "tau_beyond", tau)

    def phase(self, drive: Array) -> tuple[Array, Array]:
        """Kappa and the tightest w (...), exactly 1 and the rest at the target."""
        there = drive == target_drive(self.rest)
        size = np.hypot(1.0, self.rest)
        kappa = np.where(there, 1.0, size * np.sin(drive / 2))
        return kappa, np.where(there, self.rest, size * np.cos(drive / 2))

    def _squares_beyond(self, start: int) -> tuple[Array, Array]:
        """nu**2 (n+1,) less that of a panel column, and what is as good as nothing of it.

        Squares of slopes that differ by less than a half of them would lose it, so what they change
        by at each column is summed, in the form that loses less:

            nu_{j+1}**2 - nu_j**2 = tau_j**2 (cos_left_j**2 - cos_right_j**2).
        """
        left, right = self.tau * np.abs(self.cos_left), self.tau * np.abs(self.cos_right)
        before, after = self.slope[:-1], self.slope[1:]
        upright = left + right < before + after
        one, other = np.where(upright, (left, right), (after, before))
        size = np.where(upright, self.tau, one + other) * (one + other)
        squares = running_sums((one - other) * (one + other), start)
        return squares, ALIKE * np.abs(running_sums(size, start))


def turned(tau: Array, cosine: Array, sine: Array, w: Array, gain: Array) -> Complex:
    """exp(i (eps - delta)); ``gain`` is w - tau sin(delta)."""
    z = tau * cosine**2 + w * sine + 1j * (cosine * gain)
    size = np.hypot(z.real, z.imag)
    unit = np.empty_like(z)  # exactly 1 where z is real and positive; complex division is not
    unit.real, unit.imag = z.real / size, z.imag / size
    return unit


def interleaved(z: Complex) -> Array:
    """(..., n) complex numbers as (..., 3 n) coordinates x, y, 0."""
    coordinates = np.zeros((*z.shape, 3))
    coordinates[..., 0], coordinates[..., 1] = z.real, z.imag
    return coordinates.reshape(*z.shape[:-1], -1)


def squared_distances(
    columns: Columns, edges: Array, rows: Integers, which: Integers, drives: tuple[Array, Array]
) -> Enclosure:
    """Squared distances (S, P) of pairs of vertices, each pair in one column.

    edges: By how much the edges (m+1,) of all columns rise at the target.
    rows, which: Rows (P, 2) of the two vertices of every pair, and its column (P,) from 0.
    drives: Ends (S,) of ranges of the drive.
    """
    edge = np.arange(len(edges))
    between = (edge >= rows.min(axis=1)[:, None]) & (edge < rows.max(axis=1)[:, None])
    up, down = ((between * np.maximum(sign * edges, 0.0)).sum(axis=1) for sign in (1, -1))
    reach, rise = up + down, up - down
    size = np.hypot(1.0, columns.rest)
    half_cosine = Enclosure.half_cosine(*(ends[:, None] for ends in drives))
    packed = (reach * columns.tau_beyond[which]) ** 2 + (rise * size) ** 2
    return (half_cosine * half_cosine).times(4 * up * down * size**2).plus(packed)


def bound_edges(
    columns: Columns,
    chords: Array,
    lengths: Array,
    edges: tuple[Array, Array],
    drives: tuple[Array, Array],
) -> tuple[Array, Array]:
    """Bounds of the second derivative of edge vectors by the drive: along rows, down columns.

    chords: Lengths (n-1,) of the middle row's segments.
    lengths: Lengths (n+1,) of the longest crease between two columns, flaps at both ends.
    edges: What column 1's edges (m+1,) take along t, per unit of spread, and their slopes beyond
        that of the flattest.
    drives: Ends (S,) of ranges of the drive.
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
    kappa = Enclosure.half_sine(start, stop).times(size)
    reach, beyond = edges
    climb = kappa.hypot(beyond).second.magnitude()
    down = np.hypot(spread * reach, climb * reach)
    return along, np.asarray(down)
