"""Boards with a grain: what they bear along it, across it and in shear, all in the grain's axes.

With direct stresses d and stresses b that bending adds at the faces, each along the grain (1),
across it (2) and in shear (12), a face uses

    u_i = d_i/f_t (or -d_i/f_c) + abs(b_i)/f_m,    u_12 = (abs(d_12) + abs(b_12))/f_v,

the sum of EN 1995-1-1, 6.2.3, which is on the safe side of 6.2.4 where boards are pressed; and of
all three together

    sqrt(u_1^2 + u_2^2 + u_12^2).

C. B. Norris and P. F. McKinnon, "Compression, tension, and shear tests on yellow-poplar plywood
panels of sizes that do not buckle, with tests made at various angles to the face grain", Forest
Products Laboratory, report 1328 (1946). Shear Q across the plane makes plies roll by 3 Q/2 t, which
is compared with f_r along and across the grain likewise.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array

Grain = Literal["along rows", "along columns"]
"""Which way the grain of the faces of a panel runs: as its row creases do, or its column creases,
half way between both of them."""
ROLLING = 1.5
"""The largest shear over a section, by its mean: rolling shear is that of the whole section."""


@record
class GrainStrength:
    """What a board bears, along and across the grain of its faces (force per area)."""

    bending: Sequence[float]
    tension: Sequence[float]
    compression: Sequence[float]
    rolling_shear: Sequence[float]
    panel_shear: float  # in its plane

    def times(self, factor: float) -> GrainStrength:
        """So many times as much."""
        both = {key: tuple(factor * each for each in getattr(self, key)) for key in BOTH_WAYS}
        return GrainStrength(**both, panel_shear=factor * self.panel_shear)

    def weaker(self) -> GrainStrength:
        """The weaker of both ways in either: which way the grain runs is not known."""
        least = {key: 2 * (min(getattr(self, key)),) for key in BOTH_WAYS}
        return GrainStrength(**least, panel_shear=self.panel_shear)

    def of_axes(self, direct: Array, bent: Array, *, solid: bool) -> Array:
        """Shares (..., 3) along the grain, across it and in shear in the plane.

        direct, bent: Stresses 11, 22, 12 (..., 3) that both faces have, and what bending adds.
        solid: Whether bending bends the board; else it pulls one of two boards and presses the
        other.
        """
        pull, push = np.array(self.tension), np.array(self.compression)
        along, bends = direct[..., :2], np.abs(bent[..., :2])
        if solid:
            of_both = np.abs(along) / np.where(along > 0, pull, push)
            normal = of_both + bends / np.array(self.bending)
        else:
            normal = np.maximum((along + bends) / pull, (bends - along) / push)
        in_plane = (np.abs(direct[..., 2:]) + np.abs(bent[..., 2:])) / self.panel_shear
        return np.concatenate([normal, in_plane], axis=-1)

    def rolls(self, across: Array) -> Array:
        """Shares (...) of rolling shear, by mean shear across the plane along 1 and 2 (..., 2)."""
        rolls = ROLLING * across / np.array(self.rolling_shear)
        return np.asarray(np.linalg.norm(rolls, axis=-1))


@record
class GrainModuli:
    """How stiff a board is along and across the grain of its faces (force per area)."""

    bending: Sequence[float]
    tension: Sequence[float]
    shear: float  # in its plane

    def in_axes(self, grain: Grain | None, poisson: float) -> tuple[Array, Array]:
        """Matrices (3, 3) in the grain's axes, for forces and for moments.

        They are times E/(1 - nu^2) of the weaker way in bending, and nu^2 is the product of both
        Poisson's ratios. The weaker way is taken either way where the grain is not known.
        """
        unit = min(self.bending)
        found = []
        for both in (self.tension, self.bending):
            first, second = (each / unit for each in (both if grain else 2 * [min(both)]))
            across = poisson * np.sqrt(first * second)
            sheared = (1 - poisson**2) * self.shear / unit
            found.append(np.array([[first, across, 0], [across, second, 0], [0, 0, sheared]]))
        return found[0], found[1]


BOTH_WAYS = ("bending", "tension", "compression", "rolling_shear")


def grain_turns(flat: Array, grain: Grain | None) -> tuple[Array, Array]:
    """Angles to the grain from the first side of panels (F,), and from normals of sides (F, 4).

    flat: Corners (F, 4, 2) of panels in the flat sheet, counter-clockwise: downwards, then right.
    grain: Which way it runs; None as along rows.
    """
    a, b, c, d = flat.swapaxes(0, 1)
    along = _angle((b - a) + (c - d) if grain == "along columns" else (d - a) + (c - b))
    sides = _angle(np.roll(flat, -1, axis=1) - flat)
    return along - sides[:, 0], along[:, None] - sides + 0.5 * np.pi


def _angle(vectors: Array) -> Array:
    return np.asarray(np.arctan2(vectors[..., 1], vectors[..., 0]))
