"""The steps from column to column of an orthodiagonal sheet, along f's plane and across it."""

from __future__ import annotations

from dataclasses import field

import numpy as np

from orishell.conventions.record import record
from orishell.families.flap_sheet import other_side, target_drive
from orishell.numerics import Enclosure, Interval
from orishell.numerics.arrays import Array

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
        object.__setattr__(self, "_tightest", self._shares())

    @property
    def rest(self) -> float:
        """The smallest share of a step that is along n at the target: of the tightest columns."""
        return self._tightest[0]

    def _shares(self) -> tuple[float, float]:
        step = self.step[self.existing]
        along, across = self.locked[self.existing] / step, np.abs(self.k[self.existing]) / step
        # Nearly straight rows differ in what they take across only, the others along only.
        tightest = int(along.argmin() if along.min() < across.max() else across.argmax())
        return float(along[tightest]), float(across[tightest])

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
        sine, cosine = (
            each(start, stop).value for each in (Enclosure.half_sine, Enclosure.half_cosine)
        )
        omega = cosine.through(lambda ends: np.hypot(turn, rest * ends))
        cube = omega.through(lambda ends: 2 * ends**3)
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

    def whole_angle(self, start: Array, stop: Array) -> Enclosure:
        """The angle 2 arctan(kappa) (S, 1) over ranges (S, 1) of the drive (radians).

        It is the drive itself where all rows are straight. With s, c the sine and the cosine of
        rho/2 and w = 1/(1 + turn^2 s^2) its derivatives are w c/omega and
        -turn^2 s (1/(2 omega^3) + w c^2/omega) w.
        """
        if (turn := self._tightest[1]) <= SLIM:
            return Enclosure.variable(start, stop)
        sine, cosine = (
            each(start, stop).value for each in (Enclosure.half_sine, Enclosure.half_cosine)
        )
        omega = cosine.through(lambda ends: np.hypot(turn, self.rest * ends))
        cube = omega.through(lambda ends: 2 * ends**3)
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


def running(steps: Array) -> Array:
    """Running sums (..., n+2) of steps (..., n+1), zero at column 1."""
    sums = np.cumsum(steps[..., 1:], axis=-1)
    return np.concatenate([-steps[..., :1], np.zeros_like(steps[..., :1]), sums], axis=-1)
