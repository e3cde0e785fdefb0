"""Where a part hangs on the sheet: lines across panels, each with the face that it is on."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from itertools import chain
from typing import Self

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers


@record
class HungLines:
    """Lines (L,) across panels of the sheet, from one edge of its columns to the next."""

    names: tuple[str, ...]  # what hangs on each
    panels: Integers  # the panel (L,) of the sheet that each is on
    sides: Integers  # its face (L,): 1 top, -1 bottom
    ends: Array  # (L, 2, 2), in the flat sheet
    away: Array  # of both ends, along edges of columns, from the crease beside (L, 2)

    def __len__(self) -> int:
        return len(self.panels)

    def scaled(self, factor: float) -> Self:
        """The same on a sheet that is so many times as large."""
        return replace(self, ends=self.ends * factor, away=self.away * factor)

    @classmethod
    def joined(cls, several: Iterable[HungLines | None]) -> HungLines | None:
        """All of several, one after the other; None of none."""
        there = [each for each in several if each is not None]
        if not there:
            return None
        return cls(
            tuple(chain.from_iterable(each.names for each in there)),
            np.concatenate([each.panels for each in there]),
            np.concatenate([each.sides for each in there]),
            np.concatenate([each.ends for each in there]),
            np.concatenate([each.away for each in there]),
        )
