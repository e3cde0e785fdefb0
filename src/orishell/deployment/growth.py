"""Whether the distance of two vertices of a column grows all the way to the flat sheet, proved.

Its square is enclosed with its derivatives by the drive, over ranges that are halved until in each
of them

- the first derivative is negative (by its own bounds or by those of the second), or
- the second one is, in a range that begins with the flat sheet, or
- the second one is positive, in a range that ends at a drive of pi.

At both of these drives the first derivative vanishes, for the motion goes back as it came.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol, runtime_checkable

import numpy as np

from orishell.conventions.record import record
from orishell.numerics import Enclosure
from orishell.numerics.arrays import Array, Booleans, Integers

NARROWEST_RANGE = 2.0**-44
"""No range is halved that is a smaller part than this of the way from flat to pack."""
MOST_RANGES = 4096
"""No ranges are halved when there are more than this of one size that leave something open."""
BATCH = 64
"""Ranges that are enclosed together: memory grows with it."""
DERIVATIVE_ROUNDING = 1e-13
"""Rounding of a derivative relative to the square of the length: what is smaller has no sign."""


@runtime_checkable
class ColumnDistances(Protocol):
    """A mechanism that encloses the distances of vertices of one column.

    Its motion goes back as it came at a drive of 0, and at one of pi if it gets there.
    """

    def column_distances(
        self, rows: Integers, columns: Integers, start: Array, stop: Array
    ) -> Enclosure:
        """Squared distances (S, P) of pairs of vertices as functions of the drive.

        The pairs have ``rows`` (P, 2) and inner ``columns`` (P,), as the grid counts them; ranges
        of the drive go from ``start`` (S,) to ``stop`` (S,) (radians).
        """
        ...


@record
class Ranges:
    """Ranges of the drive, and the pairs of which something holds there."""

    start: Array  # (S,)
    stop: Array  # (S,)
    pairs: Booleans  # (S, P)

    def of(self, pair: int) -> Array:
        """Ends (2, K) of the ranges of one pair."""
        return np.stack([self.start, self.stop])[:, self.pairs[:, pair]]

    def halved(self) -> Ranges:
        """All of them in halves."""
        middle = 0.5 * (self.start + self.stop)
        return _joined(
            [Ranges(self.start, middle, self.pairs), Ranges(middle, self.stop, self.pairs)]
        )


def _joined(ranges: Sequence[Ranges]) -> Ranges:
    return Ranges(
        np.concatenate([each.start for each in ranges]),
        np.concatenate([each.stop for each in ranges]),
        np.concatenate([each.pairs for each in ranges]),
    )


def examine_growth(
    mechanism: ColumnDistances,
    rows: Integers,
    columns: Integers,
    ends: tuple[float, float],
    ceiling: Array | float = 0.0,
) -> tuple[Ranges, Ranges]:
    """Ranges in which distances do not grow towards the flat sheet, and those left undecided.

    Ranges between two drives, without those in which squares are below a ceiling (P,).
    """
    cuts = np.linspace(*ends, BATCH + 1)
    left = Ranges(cuts[:-1], cuts[1:], np.ones((BATCH, len(rows)), np.bool_))
    limit = ends[1] - ends[0]
    shrinking, size = [], limit / BATCH
    while True:
        parts = [slice(first, first + BATCH) for first in range(0, len(left.start), BATCH)]
        found = [
            _growth(mechanism, (rows, columns), (left.start[part], left.stop[part]), ceiling)
            for part in parts
        ]
        grows, shrinks = (np.concatenate(each) for each in zip(*found, strict=True))
        shrinking.append(Ranges(left.start, left.stop, left.pairs & shrinks))
        open_pairs = left.pairs & ~grows & ~shrinks
        some = open_pairs.any(axis=1)
        left = Ranges(left.start[some], left.stop[some], open_pairs[some])
        size *= 0.5
        if not 0 < len(left.start) <= MOST_RANGES or size < NARROWEST_RANGE * limit:
            return _joined(shrinking), left
        left = left.halved()


def _growth(
    mechanism: ColumnDistances,
    pairs: tuple[Integers, Integers],
    ranges: tuple[Array, Array],
    ceiling: Array | float,
) -> tuple[Booleans, Booleans]:
    """Whether distances grow towards the flat sheet all over ranges (S,), or nowhere: (S, P)."""
    start, stop = ranges
    square = mechanism.column_distances(*pairs, start, stop)
    second = square.second
    # The first derivative is near its value halfway, too: within half a range times the second.
    halfway = 0.5 * (start + stop)
    middle = mechanism.column_distances(*pairs, halfway, halfway).first
    swing = (0.5 * (stop - start))[:, None] * second.magnitude()
    low = np.maximum(square.first.low, middle.low - swing)
    high = np.minimum(square.first.high, middle.high + swing)

    margin = DERIVATIVE_ROUNDING * square.value.high
    flat, closed = (start == 0.0)[:, None], (stop == np.pi)[:, None]
    grows = (high < -margin) | (flat & (second.high < -margin)) | (closed & (second.low > margin))
    shrinks = (low >= 0) | (flat & (second.low >= 0)) | (closed & (second.high <= 0))
    below = square.value.high < ceiling - margin
    # Of a range that may be partly below the ceiling, its halves say more.
    judged = (square.value.low >= ceiling) | (np.asarray(ceiling) == 0)
    return grows | below, shrinks & ~below & judged
