"""The most even sheet of those whose column 1 is given, up to its size.

Its shortest inner crease is 1 and its longest as short as can be. That is a linear program in few
unknowns, with many solutions as often as not. Of these the one is taken whose middle row and column
1 are the shortest vector: it is unique, and does not jump when what is asked for moves a little.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.families.longitudinal_linear_repeating.tessellation.columns import Directions
from orishell.families.longitudinal_linear_repeating.tessellation.lengths import (
    END_SHARE,
    InnerLengths,
    end_limits,
)
from orishell.numerics.arrays import Array, Booleans

LARGEST_RATIO = 1000.0
"""A sheet whose longest inner crease is more than this times the shortest does not count."""
LENGTH_ROUNDING = 1e-10
"""Lengths meet a condition if they miss it by no more, over the longest."""
NOWHERE = 0.5 / LARGEST_RATIO**2
"""1/(1 + d^2) is smaller where the most even sheet is at a distance d that does not count."""
CHOICE = 1e-3
"""By so much the lengths of the middle row and column 1 count beside the longest of all: what makes
one sheet of those whose longest is equally short. It was at most 2e-8 longer than need be."""


@record
class FollowingSheets:
    """All sheets whose column 1 has lengths in given ratios, their lengths linear in k unknowns.

    As a vector, the unknowns are as long as all lengths of the middle row and column 1 are.
    """

    row: Array  # lengths (n-1, k) of the middle row
    column: Array  # lengths (m-1, k) of column 1
    every: Array  # lengths (N, k) of all inner creases
    rim: Booleans  # which of them (N,) are likely to be the shortest or the longest
    scale: Array  # of the wanted column (k,)
    room: Array  # what must not be negative (R, k), so that column 1's ends have room

    @classmethod
    def of(
        cls,
        directions: Directions,
        ratios: Array,
        row: Array | None,
        ends: tuple[float, float] | None,
        advance: tuple[Array, float] | None,
    ) -> FollowingSheets:
        """The sheets of given directions.

        ratios: Of column 1's inner lengths (m-1,), m at least 2; ``row``, ``ends`` and ``advance``
        are those of :class:`Wanted`.
        """
        m, n = directions.row.shape[0], directions.column.shape[1]
        rows = np.eye(n - 1) if row is None else row[:, None]
        free = np.zeros((n - 1 + m - 1, rows.shape[1] + 1))
        free[: n - 1, :-1], free[n - 1 :, -1] = rows, ratios
        if advance is not None:
            weights, total = advance
            excess = np.append(weights @ rows, -total)
            free = free @ np.linalg.svd(excess[None])[2][1:].T
        rows, column = np.split(np.linalg.qr(free)[0], [n - 1])
        made = InnerLengths.marched(directions, rows.T, column.T)
        count = rows.shape[1]
        scale = ratios @ column / (ratios @ ratios)
        room = []
        for bottom, end, place in zip((False, True), ends or (), (0, -1), strict=False):
            limit = END_SHARE * end_limits(directions, np.ones((m, n - 1)), bottom)[0]
            if np.isfinite(limit):
                room.append(limit * made.row[:, place, 0] - end * scale)
        parts = [each.reshape(count, -1).T for each in (made.row, made.column)]
        rim = [np.zeros(each.shape[1:], np.bool_) for each in (made.row, made.column)]
        rim[0][[0, m // 2, -1]] = rim[1][[0, -1]] = True
        return cls(
            row=rows,
            column=column,
            every=np.concatenate(parts),
            rim=np.concatenate([each.ravel() for each in rim]),
            scale=scale,
            room=np.reshape(room, (-1, count)),
        )

    def most_even(self) -> tuple[Array, Array] | None:
        """Lengths (n-1,) of the middle row and (m-1,) of column 1, the shortest of all being 1.

        In coordinates that are the longest length and the unknowns times :data:`CHOICE` it is the
        point nearest to the origin of those that satisfy linear conditions (C. L. Lawson and R. J.
        Hanson, Solving Least Squares Problems, 1974, section 23.4).
        """
        from scipy.optimize import nnls

        count, unknowns = self.every.shape
        conditions = np.zeros((unknowns + 2, 2 * count + len(self.room)))
        conditions[:unknowns, :count] = self.every.T / CHOICE
        conditions[:unknowns, count : 2 * count] = -conditions[:unknowns, :count]
        conditions[:unknowns, 2 * count :] = self.room.T / CHOICE
        conditions[unknowns, count : 2 * count] = 1.0
        conditions[-1, :count] = 1.0
        goal = np.append(np.zeros(unknowns + 1), 1.0)
        asked = np.concatenate([self.rim, self.rim, np.ones(len(self.room), np.bool_)])
        while True:
            part = conditions[:, asked]
            forces = nnls(part, goal)[0]
            if (goal - part @ forces)[-1] < NOWHERE:
                return None
            # The conditions that hold it there, alone: freed of the rounding of all others.
            met = part[:, forces > 0]
            nearest = np.linalg.lstsq(met[:-1].T, met[-1], rcond=None)[0]
            missed = (
                conditions[-1] - nearest @ conditions[:-1] > LENGTH_ROUNDING * nearest[unknowns]
            )
            if not (missed & ~asked).any():
                break
            asked |= missed
        found = nearest[:unknowns] / CHOICE
        return self.row @ found, self.column @ found

    def advance_limits(self, weights: Array, low: float, high: float) -> tuple[float, float] | None:
        """Least and greatest weighted sum of the middle row, with column 1 as long as wanted.

        low, high: Bounds of all lengths.
        """
        from scipy.optimize import linprog

        between = np.concatenate([self.every, -self.every, -self.room])
        bounds = np.repeat([high, -low, 0.0], [len(self.every)] * 2 + [len(self.room)])
        limits = []
        for sign in (1.0, -1.0):
            cost = sign * weights @ self.row
            found = linprog(cost, between, bounds, self.scale[None], [1.0], (None, None))
            if found.x is None:
                return None
            limits.append(float(self.row @ found.x @ weights))
        return limits[0], limits[1]
