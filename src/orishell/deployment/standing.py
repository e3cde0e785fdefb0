"""How a shell stands on the ground while it moves: the middle between its feet stays where it is.

A crew that opens or closes a shell moves both rows of feet alike. In every state

- the middle between both rows of feet is where it is at the target,
- the line from one row to the other has the direction in plan, and the slope, of the target,
- about that line the shell is turned as its mechanism has it.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.deployment.fixings import Fixings
from orishell.motion import Mechanism, area_of
from orishell.motion.hinge_lines import IN_CREASES, HingeLines
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array, Integers

MET = 1e-9
"""Feet that are nearer than this, relative to the sheet's size, have no direction from each other:
that of a state shortly before is theirs."""
BEFORE = 1e-8
"""So shortly, as a share of the drive."""


@record
class Place:
    """Where the ground is in states (...), in the frame of the mechanism."""

    middle: Array  # (..., 3), the middle between both rows of feet
    # (..., 3, 3), unit vectors: along the ground from the first row to the last, to the left, up
    axes: Array
    apart: Array  # (..., P, 3), from the first foot to the last in every column
    along: Array  # (..., 3), the mean of these, or its direction where they meet

    def seen(self, points: Array) -> Array:
        """Points (..., N, 3) of the mechanism's frame from the middle, along the axes."""
        return np.asarray((points - self.middle[..., None, :]) @ np.swapaxes(self.axes, -1, -2))


@record
class Standing:
    """A mechanism on its feet."""

    mechanism: Mechanism
    feet: Fixings  # pairs of feet, one of either row
    slope: Array  # (2,), sine and cosine of the slope of the line from one row to the other
    size: float  # of the sheet: the side of a square of its area (length)

    @classmethod
    def of(
        cls,
        mechanism: Mechanism,
        feet_rows: tuple[int, int],
        columns: Integers | None = None,
        hinges: HingeLines = IN_CREASES,
    ) -> Standing:
        """On the feet of two rows, in these columns, or all inner ones; the ground as it is there.

        hinges: Those of whole boards, whose corners are the feet then.
        """
        if columns is None:
            columns = np.arange(mechanism.grid.columns)[mechanism.inner_columns]
        rows = np.broadcast_to(feet_rows, (len(columns), 2))
        feet = Fixings(mechanism, rows, columns, hinges)
        first, last = np.moveaxis(feet.at(mechanism.target_drive), -2, 0)
        line = (last - first).mean(axis=0)
        slope = np.array([line[2], np.hypot(*line[:2])]) / np.linalg.norm(line)
        return cls(mechanism, feet, slope, float(np.sqrt(area_of(mechanism))))

    def place(self, drives: ArrayLike) -> Place:
        """Where the ground is at drives (...) (radians)."""
        drives = np.asarray(drives, dtype=np.float64)
        feet = self.feet.at(drives)
        apart = feet[..., 1, :] - feet[..., 0, :]
        along = np.asarray(apart.mean(axis=-2))
        met = lengths(along) < MET * self.size
        if met.any():
            before = self.feet.at(drives[met] * (1 - BEFORE))
            along[met] = (before[..., 1, :] - before[..., 0, :]).mean(axis=-2)
        line = along / lengths(along)[..., None]
        square = np.array([0.0, 0.0, 1.0]) - line[..., 2:] * line
        square /= lengths(square)[..., None]
        sine, cosine = self.slope
        up, forward = sine * line + cosine * square, cosine * line - sine * square
        axes = np.stack([forward, np.cross(up, forward), up], axis=-2)
        return Place(feet.mean(axis=(-3, -2)), axes, apart, along)

    def turning(
        self, first: Array, last: Array, ranges: tuple[Array, Array]
    ) -> tuple[Array, Array]:
        """How far the ground turns in ranges (S,), and how far that is from even (radians).

        By the vectors (S, 3) between the feet at both ends.
        """
        step = ranges[1] - ranges[0]
        acceleration = self.feet.accelerations(*ranges).mean(axis=-1)
        off = step**2 / 8 * acceleration
        long, change = np.stack([lengths(first), lengths(last)]), last - first
        angle = np.arctan2(lengths(np.cross(first, last)), (first * last).sum(axis=-1))
        nearest = long.min(axis=0) * np.cos(0.5 * angle) - off
        met = long[1] < MET * self.size
        with np.errstate(divide="ignore", invalid="ignore"):
            swing = angle + np.arcsin(np.clip(off / (nearest + off), 0.0, 1.0))
            swing = np.where(nearest > 0, swing, np.pi)
            # Where feet meet at the end, vectors over what is left of the way have the direction.
            at_end = 0.5 * acceleration * step**2 / long[0]
            swing = np.where(
                met, np.where(at_end < 1, 2 * np.arcsin(np.minimum(at_end, 1)), np.pi), swing
            )
            level = np.arcsin(np.abs(np.stack([first[:, 2], last[:, 2]]) / long).clip(0, 1)).max(
                axis=0
            )
            cosine = np.cos(np.minimum(level + swing, 0.5 * np.pi))
            cosine = np.where(cosine > 1e-9, cosine, 0.0)
            speed = lengths(change) / step + 0.5 * acceleration * step
            aside = lengths(np.cross(first, change)) / long[0] / step
            aside += lengths(change) * swing / step + 0.5 * acceleration * step
            v = aside / nearest
            second = acceleration / nearest + 2 * speed * v / nearest + v**2
            uneven = step**2 / 8 * (2 * second / cosine + 5 * v**2 / cosine**2)
            uneven = np.where((nearest > 0) & ~met & (cosine > 0), uneven, np.inf)
            return np.where(cosine > 0, swing / cosine, np.inf), uneven
