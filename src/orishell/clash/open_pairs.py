"""Pairs that are not proved apart in a range of the path, and what is remembered of them.

A proof lacks the part of the chord error that is more than the gap, and the chord error is a
quarter in half the range: so it is known about when it is worth looking again, and along which
direction.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.clash.broad_phase import Pairs, joined, selected
from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans, Integers

EARLY, SOONEST = 1.5, 0.125
"""A pair that lacks a proof is looked at again at this multiple of the step that would do, or at
this share of the step at least."""


def step_to_wait_for(step: float, room: Array, bound: Array) -> Array:
    """Steps (P,) at which pairs are looked at again, whose room (P,) is below their bound (P,).

    At half of this step at most, and at once where there is no bound.
    """
    share = np.maximum(room, 0.0) / np.maximum(bound, 1e-300)
    return np.asarray(step * np.clip(EARLY * np.sqrt(share), SOONEST, 0.5))


@record
class OpenPairs:
    """Pairs of panels, or of bodies, that are not proved apart."""

    pairs: Pairs
    kept_by: Integers  # (P,), of bodies: the direction that parted them most
    sleep: Array  # (P,), steps that are longer need no look (radians)

    @classmethod
    def new(cls, pairs: Pairs) -> OpenPairs:
        """Pairs of which nothing is known."""
        count = len(pairs[0])
        return cls(pairs, np.zeros(count, np.int64), np.full(count, np.inf))

    @classmethod
    def joined(cls, parts: Sequence[OpenPairs]) -> OpenPairs:
        """Several lists as one."""
        return cls(
            joined([each.pairs for each in parts]),
            np.concatenate([each.kept_by for each in parts]),
            np.concatenate([each.sleep for each in parts]),
        )

    def __len__(self) -> int:
        return len(self.sleep)

    def chosen(self, which: Booleans) -> OpenPairs:
        """Those at which ``which`` (P,) is true."""
        return OpenPairs(selected(self.pairs, which), self.kept_by[which], self.sleep[which])
