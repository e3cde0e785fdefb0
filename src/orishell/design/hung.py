"""Where parts hang on others: lines across panels, each with the face that it is on."""

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
    """Lines (L,) across panels of a part, from one edge of its columns to the next."""

    names: tuple[str, ...]  # what hangs on each
    panels: Integers  # the panel (L,) of the part that each is on
    sides: Integers  # its face (L,): 1 top, -1 bottom
    ends: Array  # (L, 2, 2), in the flat sheet
    away: Array  # of both ends, along edges of columns, from the crease beside (L, 2)

    def __len__(self) -> int:
        return len(self.panels)

    @classmethod
    def between(
        cls, names: tuple[str, ...], panels: Integers, side: int, points: Array, away: Array
    ) -> Self:
        """Lines of one face between points (K, n, 2) on columns, row by row.

        Parameters
        ----------
        away
            How far points are along edges of columns from the crease beside (K, n).
        """
        return cls(
            names=names,
            panels=panels,
            sides=np.full(len(panels), side),
            ends=np.stack([points[:, :-1], points[:, 1:]], axis=2).reshape(-1, 2, 2),
            away=np.stack([away[:, :-1], away[:, 1:]], axis=2).reshape(-1, 2),
        )

    def of(self, name: str) -> Self:
        """Those on which a part of a name hangs."""
        mine = np.array([each == name for each in self.names], np.bool_)
        return replace(
            self,
            names=(name,) * int(mine.sum()),
            panels=self.panels[mine],
            sides=self.sides[mine],
            ends=self.ends[mine],
            away=self.away[mine],
        )

    def moved(self, first: int, move: Array) -> Self:
        """The same where the part is moved, and its first panel has another number."""
        return replace(self, panels=self.panels + first, ends=self.ends + move)

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
