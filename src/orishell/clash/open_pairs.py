"""Pairs that are not proved apart in a range of the path, and what is remembered of them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.clash.broad_phase import Pairs, joined, selected
from orishell.conventions.record import record
from orishell.numerics.arrays import Booleans, Integers


@record
class OpenPairs:
    """Pairs of panels, or of bodies, that are not proved apart."""

    pairs: Pairs
    kept_by: Integers  # (P,), of bodies: the direction that parted them most

    @classmethod
    def new(cls, pairs: Pairs) -> OpenPairs:
        """Pairs of which nothing is known."""
        return cls(pairs, np.zeros(len(pairs[0]), np.int64))

    @classmethod
    def joined(cls, parts: Sequence[OpenPairs]) -> OpenPairs:
        """Several lists as one."""
        return cls(
            joined([each.pairs for each in parts]),
            np.concatenate([each.kept_by for each in parts]),
        )

    def __len__(self) -> int:
        return len(self.kept_by)

    def chosen(self, which: Booleans) -> OpenPairs:
        """Those at which ``which`` (P,) is true."""
        return OpenPairs(selected(self.pairs, which), self.kept_by[which])
