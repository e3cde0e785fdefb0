"""Holes that are drilled through the boards of a part."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers


@record
class Holes:
    """Holes (N,) along edges, each for one bracket that holds a board on what it stands beside."""

    panels: Integers  # the panel (N,) that each is in
    middles: Array  # where they are (N, 2) on the flat part
    diameters: Array  # (N,)
    lengths: Array  # of the edge that each has to itself (N,)

    def __len__(self) -> int:
        return len(self.panels)

    def moved(self, panels: int, shift: Array) -> Holes:
        """The same shifted (2,), their panels numbered from another number on."""
        return replace(self, panels=self.panels + panels, middles=self.middles + shift)

    @classmethod
    def joined(cls, several: Sequence[Holes]) -> Holes | None:
        """All of several, one after the other; None of none."""
        if not several:
            return None
        return cls(
            np.concatenate([each.panels for each in several]),
            np.concatenate([each.middles for each in several]),
            np.concatenate([each.diameters for each in several]),
            np.concatenate([each.lengths for each in several]),
        )
