"""Holes that are drilled through the boards of a part."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.motion.boards import Boards
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

    def through(
        self, boards: Boards, faces: Integers, flat: Array, positions: Array
    ) -> tuple[Integers, Array, Array]:
        """Where holes go through boards in a folded state.

        The panels have the corners ``faces`` (F, 4); the vertices are ``flat`` (V, 2) in the flat
        sheet and ``positions`` (V, 3) in the state.

        Returns
        -------
        tuple
            For every hole and every board that it goes through, the board (N,), the ends (N, 2, 3)
            of the hole's axis on both faces of the board, the lower one first, and the hole's
            diameter (N,).
        """
        there = (boards.panels[:, None] == self.panels) & ~boards.arms[:, None]
        board, hole = np.nonzero(there)
        heights = boards.outlines[board][:, [0, -1], 0, 2]
        middles = np.repeat(self.middles[hole][:, None], 2, axis=1)
        lying = np.concatenate([middles, heights[..., None]], axis=-1)
        axes = replace(boards.chosen(board), outlines=lying[:, :, None])
        return board, axes.carried(faces, flat, positions)[:, :, 0], self.diameters[hole]

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
