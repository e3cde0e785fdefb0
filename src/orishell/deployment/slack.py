"""Ties that stay slack, by the bounds of accelerations that the proof of contact rests on.

For mechanisms that do not enclose distances themselves, and for ties of whole boards. Let e be the
vector between two ends, L its length at the target, and A a bound of its acceleration over a range
of the drive of width h. With D the mean rate there and l the straight line between its values e_a
and e_b at both ends,

    abs(e - l) <= A h^2/8,     abs(e' - D) <= A h/2,

so that a tie is slack all over the range if max(abs(e_a), abs(e_b)) + A h^2/8 < L. It is, too, if
it is slack where the range begins, or that is the target, and its vertices approach each other
from there on, as

    e e' <= max(e_a D, e_b D) + max(abs(e_a), abs(e_b)) A h/2 + (abs(D) + A h/2) A h^2/8 < 0.

Ranges from the target to the pack are halved until one of both holds in each. In the first it is
the second, so that opening the shell at its target stretches a tie that is proved to be slack.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.deployment.fixings import Fixings
from orishell.motion.quads import dots, lengths
from orishell.numerics.arrays import Array, Booleans

BEYOND = 1e-2
"""Where flaps end the motion at the target, the sheet without them is looked at so far beyond
(radians): enough to see that opening it stretches ties."""
FIRST = 16
"""Ranges that are begun with."""
NARROWEST_RANGE = 2.0**-30
"""No range is halved that is a smaller part than this of the way from the target to the pack."""
MOST_RANGES = 2048
"""No ranges are halved when there are more than this of one size that leave something open."""
BATCH = 64
"""Ranges that are looked at together: memory grows with it."""
LENGTH_ROUNDING = 1e-12
"""Rounding of lengths and bounds of accelerations, relative: thousands of times what they have."""


@record
class Slack:
    """Which ties are proved to be slack between the target and the pack."""

    proved: Booleans  # (P,)
    fails_at: Array  # (P,), the drive nearest to the target at which one is not (radians)


@record
class _Pairs:
    """Ties by their two ends."""

    fixings: Fixings
    taut: Array  # (P,), how far their ends are apart at the target

    @classmethod
    def of(cls, fixings: Fixings) -> _Pairs:
        found = cls(fixings, np.zeros(len(fixings.columns)))
        target = np.array([fixings.mechanism.target_drive])
        return replace(found, taut=lengths(found.apart(target))[0])

    def apart(self, drives: Array) -> Array:
        """Vectors (S, P, 3) from the first end of every tie to the second at drives (S,)."""
        places = self.fixings.at(drives)
        return np.asarray(places[..., 1, :] - places[..., 0, :])

    def examine(self, start: Array, stop: Array) -> tuple[Booleans, Booleans]:
        """Whether they are nearer than at the target in ranges (S,); or are not at the end."""
        first, last = np.split(self.apart(np.concatenate([start, stop])), 2)
        width = (stop - start)[:, None]
        bound = (1 + LENGTH_ROUNDING) * self.fixings.accelerations(start, stop)
        off, swing = width**2 / 8 * bound, width / 2 * bound
        before, after, taut = lengths(first), lengths(last), self.taut
        longest = np.maximum(before, after)
        near = longest + off < (1 - LENGTH_ROUNDING) * taut
        rate = (last - first) / width[..., None]
        shrinking = (
            np.maximum(dots(first, rate), dots(last, rate))
            + longest * swing
            + off * (lengths(rate) + swing)
            # Rounding of the two vectors, by which the mean rate may be wrong.
            + LENGTH_ROUNDING * longest * taut / width
        )
        begun = (start == self.fixings.mechanism.target_drive)[:, None] | (
            before < (1 - LENGTH_ROUNDING) * taut
        )
        return near | ((shrinking < 0) & begun), after > (1 + LENGTH_ROUNDING) * taut


def find_slack(fixings: Fixings, limit: float) -> Slack:
    """Whether ties (P,) with these ends are shorter than at the target up to a drive.

    Where flaps end the motion at the target there is nothing between target and pack: then it is
    whether opening the shell stretches them there, by the sheet without flaps.

    limit: The drive of the pack, at least that of the target (radians).
    """
    mechanism, columns = fixings.mechanism, fixings.columns
    target, count = mechanism.target_drive, len(columns)
    bare = mechanism.without_flaps()
    if limit <= target and bare is not mechanism:
        beyond = min(bare.end_drive, bare.target_drive + BEYOND)
        inner = columns - mechanism.inner_columns.start
        found = find_slack(replace(fixings, mechanism=bare, columns=inner), beyond)
        return replace(found, fails_at=np.where(found.proved, np.inf, target))
    pairs = _Pairs.of(fixings)
    cuts = np.linspace(target, limit, FIRST + 1)
    start, stop = cuts[:-1], cuts[1:]
    left = np.full((FIRST, count), limit > target)
    fails_at = np.full(count, np.inf)
    size = (limit - target) / FIRST
    while left.any():
        parts = [
            pairs.examine(start[part], stop[part])
            for part in (slice(k, k + BATCH) for k in range(0, len(start), BATCH))
        ]
        slack, over = (np.concatenate(each) for each in zip(*parts, strict=True))
        fails_at = np.minimum(fails_at, np.where(left & over, stop[:, None], np.inf).min(axis=0))
        # What is beyond a place where a tie is not slack already needs no proof.
        left = left & ~slack & ~over & (start[:, None] < fails_at)
        some = left.any(axis=1)
        start, stop, left = start[some], stop[some], left[some]
        size *= 0.5
        if len(start) > MOST_RANGES or size < NARROWEST_RANGE * (limit - target):
            break
        middle = 0.5 * (start + stop)
        start, stop = np.concatenate([start, middle]), np.concatenate([middle, stop])
        left = np.concatenate([left, left])
    if left.any():
        fails_at = np.minimum(fails_at, np.where(left, start[:, None], np.inf).min(axis=0))
    return Slack(np.isinf(fails_at), fails_at)
