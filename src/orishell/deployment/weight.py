"""What a shell's own weight does to it on the way from flat to packed, by virtual work.

With V the potential energy of the panels over the feet and L the distance of the feet,
both functions of the drive, the feet push outwards by

    thrust = -dV/dL:

positive where gravity opens the shell and ties must hold the feet, negative where it closes it and
flaps must keep them apart. Panels are rigid: with a panel's two triangles of areas a and b,

    (a + b) centroid = a (p + q + r)/3 + b (p + r + s)/3,

so every vertex carries a share of the area that never changes.

V and L are polynomials of the drive through nearby states, and the thrust is the ratio of their
derivatives: of their second ones at the target of a shell with flaps, where both are stationary. In
the flat sheet L is stationary and V is not: no force at the feet raises it, only a push from below,
and what raising takes is given as work.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.polynomial.chebyshev import chebder, chebfit, chebval
from numpy.typing import ArrayLike

from orishell.conventions.record import Angle, record
from orishell.deployment.standing import Standing
from orishell.motion import Mechanism
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.hinge_lines import IN_CREASES, HingeLines
from orishell.motion.hinges import Hinges
from orishell.motion.layout import Layout, points_of
from orishell.motion.mechanism import panel_normals
from orishell.motion.quads import dots, lengths, signed_areas
from orishell.numerics.arrays import Array, Integers

NODES = 11
"""States that the polynomials go through."""
UNIT_NODES = -np.cos(np.pi * np.linspace(0, 1, NODES))
"""Where they are, between -1 and 1."""
AT_ONCE = 100_000
"""Vertices that are placed at once, to bound the memory."""
REACH, REACH_FROM_END = 0.02, 0.1
"""They cover this much of the drive to either side (radians), and at most a tenth of the drive."""
HALVINGS, TAIL = 12, 1e-12
"""So often is that halved at most, until the last coefficients are smaller than this.

Columns whose zigzags nearly close at the target change within a small part of the drive. The thrust
is right to some 1e-9 of the weight, and to 2e-6 where the zigzag of a column nearly closes.
"""
STATIONARY = 1e-6
"""Slope of L at the end, relative to its curvature, that is none."""


@record
class OwnWeight:
    """A shell under its own weight, from flat to packed, without ties and flaps clipped on."""

    REPORTED = (
        "force_unit",
        "total",
        "at_feet",
        "largest_from_pack",
        "tipping",
        "raise_from_flat",
        "raise_from_pack",
        "drives",
        "forces",
    )

    force_unit: Literal["N", "weight"]  # Newtons, or the shell's weight if its mass is not known
    total: float  # its weight
    # force at the target by which the feet, all of one side together, push outwards: positive where
    # own weight opens the shell and ties carry it, negative where flaps do
    at_feet: float
    # the largest force at the feet on the way from the end of the motion to the target
    largest_from_pack: float
    tipping: tuple[Angle, ...]  # drives at which the shell would fall to either side
    # what raising it takes: work, in the unit of force times metres
    raise_from_flat: float
    raise_from_pack: float
    # the force at the feet along the motion; None where none raises or holds it
    drives: tuple[Angle, ...]
    forces: tuple[float | None, ...]
    # at the same drives (N,), potential energy of the panels over the feet (force times length),
    # and distance of the feet, the mean of all columns that have feet (length)
    energy: Array
    span: Array


def measure_weight(
    mechanism: Mechanism,
    feet_rows: tuple[int, int],
    weight_per_area: float | None,
    *,
    metres: float = 1.0,
    pack: float | None = None,
    columns: Integers | None = None,
    hinges: HingeLines = IN_CREASES,
    states: int = 91,
) -> OwnWeight:
    """Return what a shell's own weight does along its motion.

    The feet move on ground that rises from one to the other as it does at the target. Heights are
    measured over the middle between them; states that are tilted against that are turned back.
    Flaps weigh as much as other panels, as far as the mechanism has them.

    Parameters
    ----------
    feet_rows
        Rows of vertices that are its feet.
    weight_per_area
        Weight of the panels (N per length squared); None if it is not known.
    metres
        The unit of length, for work (m).
    pack
        Drive angle of the pack (radians); None for the end of the motion.
    columns
        Columns (K,) in which both rows have a foot; all inner ones if None.
    hinges
        Those of whole boards, which carry the weight, and stand on their corners half way up; None
        without such boards.
    states
        Number of states from flat to the pack, the target not counted.
    """
    body = Body.of(mechanism, feet_rows, weight_per_area or 1.0, columns, hinges)
    total = body.weight * float(body.shares.sum())
    unit = total if weight_per_area is None else 1.0
    target = mechanism.target_drive
    end = mechanism.end_drive if pack is None else pack
    drives = np.union1d(np.linspace(0.0, end, states), [target])
    energy, span = body.at(drives)
    thrust = body.thrusts(drives)
    there = int(np.searchsorted(drives, target))
    return OwnWeight(
        force_unit="weight" if weight_per_area is None else "N",
        total=total / unit,
        at_feet=float(thrust[there]) / unit,
        largest_from_pack=float(np.nanmax(np.abs(thrust[there:]))) / unit,
        tipping=_tipping(drives, energy),
        raise_from_flat=_climb(energy[: there + 1]) * metres / unit,
        raise_from_pack=_climb(energy[there:][::-1]) * metres / unit,
        drives=tuple(drives.tolist()),
        forces=tuple(None if np.isnan(force) else force / unit for force in thrust.tolist()),
        energy=energy / unit,
        span=span,
    )


@record
class Body:
    """A mechanism on its feet, the area (V,) that vertices carry, and that of panels (F,)."""

    standing: Standing
    weight: float
    shares: Array
    areas: Array

    @classmethod
    def of(
        cls,
        mechanism: Mechanism,
        feet_rows: tuple[int, int],
        weight: float,
        columns: Integers | None = None,
        hinges: HingeLines = IN_CREASES,
    ) -> Body:
        """Of panels of a weight per area, on feet as :meth:`Standing.of` has them."""
        corners, faces = panels_laid_flat(mechanism), Layout.of(mechanism).faces
        shares = np.zeros(int(faces.max()) + 1)
        areas = np.zeros(len(faces))
        for triangle in ([0, 1, 2], [0, 2, 3]):
            p, q, r = (corners[:, k] for k in triangle)
            area = signed_areas(np.stack([p, q, r], axis=1))
            areas += area
            np.add.at(shares, faces[:, triangle], area[:, None] / 3)
        standing = Standing.of(mechanism, feet_rows, columns, hinges)
        return cls(standing, weight, shares, areas)

    @property
    def mechanism(self) -> Mechanism:
        """The folding sheet."""
        return self.standing.mechanism

    def at(self, drives: ArrayLike) -> tuple[Array, Array]:
        """Energy and span (...) at drives (...)."""
        drives = np.asarray(drives, dtype=np.float64)
        each = max(1, AT_ONCE // len(self.shares))
        parts = [self._at(drives.flat[k : k + each]) for k in range(0, drives.size, each)]
        energy, span = np.concatenate(parts, axis=-1)
        return energy.reshape(drives.shape), span.reshape(drives.shape)

    def _at(self, drives: Array) -> tuple[Array, Array]:
        place = self.standing.place(drives)
        height = dots(self._centre(drives) - place.middle, place.axes[..., 2, :])
        span = lengths(place.apart).mean(axis=-1)
        return self.weight * self.shares.sum() * height, span

    def _centre(self, drives: Array) -> Array:
        """The centre of mass (..., 3) at drives (...)."""
        points = points_of(self.mechanism, drives)
        centre = np.einsum("v,...vx->...x", self.shares, points) / self.shares.sum()
        hinges = self.standing.feet.hinges
        if not isinstance(hinges, Hinges):
            return np.asarray(centre)
        middles = hinges.middles(panel_normals(self.mechanism.positions(drives)))
        areas = self.areas.reshape(hinges.levels.shape) / self.areas.sum()
        return np.asarray(centre + np.einsum("rc,...rcx->...x", areas, middles))

    def thrusts(self, drives: Array) -> Array:
        """The thrust -dV/dL at drives (N,); not a number where L is stationary on the way.

        By polynomials through V and L, over less and less of them until they follow both.
        """
        end = self.mechanism.end_drive
        reach = np.minimum(np.where(drives < end, REACH, REACH_FROM_END), 0.1 * drives)
        thrusts, least = np.full(drives.shape, np.nan), np.full(drives.shape, np.inf)
        some = np.arange(len(drives))
        for _ in range(HALVINGS):
            if not len(some):
                break
            low, high = drives[some] - reach[some], np.minimum(drives[some] + reach[some], end)
            energy, span = self.at(low + 0.5 * (1 + UNIT_NODES[:, None]) * (high - low))
            step = np.diff(span, axis=0)
            monotone = np.asarray((step > 0).all(axis=0) | (step < 0).all(axis=0))
            some, low, high = some[monotone], low[monotone], high[monotone]
            fits = _Fits.of(low, high, energy[:, monotone], span[:, monotone])
            tails = fits.tails(self.weight * float(self.shares.sum()))
            better = tails < least[some]
            thrusts[some[better]] = fits.thrusts(drives[some])[better]
            least[some[better]] = tails[better]
            some = some[tails > TAIL]
            reach[some] *= 0.5
        return thrusts


@record
class _Fits:
    """Polynomials through V and L between drives low and high (N,)."""

    low: Array
    high: Array
    energy: Array  # coefficients (NODES, N) of Chebyshev's polynomials
    span: Array
    changes: tuple[Array, Array]  # of V and L (N,)

    @classmethod
    def of(cls, low: Array, high: Array, energy: Array, span: Array) -> _Fits:
        """Through V and L (NODES, N) at the nodes."""
        changes = np.ptp(energy, axis=0), np.ptp(span, axis=0)
        v, length = (
            np.asarray(chebfit(UNIT_NODES, each, NODES - 1), dtype=np.float64)
            for each in (energy, span)
        )
        return cls(low, high, v, length, changes)

    def tails(self, weight: float) -> Array:
        """What may be missing of them: their last two coefficients (N,), relative to the changes.

        A change of V is at least the weight times that of L.
        """
        rise, change = self.changes
        scale = rise + weight * change
        last, last_span = (np.abs(each[-2:]).sum(axis=0) for each in (self.energy, self.span))
        weighs = np.divide(last, scale, out=np.zeros_like(last), where=scale > 0)
        return np.asarray(np.maximum(weighs, last_span / change))

    def thrusts(self, drives: Array) -> Array:
        """-dV/dL (N,) at drives between low and high."""
        half = 0.5 * (self.high - self.low)
        places = (drives - self.low) / half - 1
        v, length = (
            [chebval(places, chebder(each, order), tensor=False) / half**order for order in (1, 2)]
            for each in (self.energy, self.span)
        )
        stationary = np.abs(length[0]) < STATIONARY * np.abs(length[1])
        with np.errstate(divide="ignore", invalid="ignore"):
            return -np.where(stationary, v[1] / length[1], v[0] / length[0])


def _climb(energy: Array) -> float:
    """Sum of all rises of the energy (N,)."""
    return float(np.maximum(np.diff(energy), 0).sum())


def _tipping(drives: Array, energy: Array) -> tuple[float, ...]:
    """Drives where the energy (N,) is largest between two others: tops of parabolas."""
    found = []
    for k in 1 + np.flatnonzero((energy[1:-1] > energy[:-2]) & (energy[1:-1] >= energy[2:])):
        near = slice(k - 1, k + 2)
        curve = np.polynomial.Polynomial.fit(drives[near], energy[near], 2)
        found.append(float(curve.deriv().roots()[0]))
    return tuple(found)
