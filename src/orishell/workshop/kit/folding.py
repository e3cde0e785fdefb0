"""How a sheet of card is folded by hand: which creases first, from where it is pushed, how far."""

from __future__ import annotations

import numpy as np

from orishell.conventions.quantities import box
from orishell.conventions.record import record
from orishell.document import FLAT, OPEN, SHELL, Document
from orishell.numerics.arrays import Array, Booleans, Integers

BEGUN, ALMOST = 0.25, 0.6
"""Shares of the way to the target that pictures show."""


@record
class CreaseLines:
    """Creases by their ends: vertices (K, 2) of mountains, and of valleys (L, 2)."""

    mountains: Integers
    valleys: Integers

    @property
    def count(self) -> int:
        """How many there are."""
        return len(self.mountains) + len(self.valleys)


@record
class HandFolding:
    """What hands do, in their order."""

    every: CreaseLines
    # creases along rows and those along columns, those first that fold more as it begins; one if
    # panels are no grid, or fold along one of both only
    sets: tuple[CreaseLines, ...]
    # whether opposite edges that are pushed lie left and right in the flat sheet, else above and
    # below
    sideways: bool
    states: tuple[int, ...]  # numbers of the states on the way, the target left out


def hand_folding(document: Document) -> HandFolding:
    """How the sheet of a document with states is folded."""
    edges = np.asarray(document.mesh.edges)
    letters = np.array(document.assignment)
    states = tuple(dict.fromkeys(state_between(document, FLAT, each) for each in (BEGUN, ALMOST)))
    folds = np.isin(letters, ("M", "V"))
    angles = document.state(states[0]).fold_angles_deg
    sets = [CreaseLines(*_ends(edges, letters, folds))]
    if document.grid_shape is not None and angles is not None:
        across = document.grid_shape[1]
        apart = np.abs(edges[:, 1] - edges[:, 0])
        both = [folds & (apart == step) for step in (1, across)]
        size = np.abs(np.nan_to_num(angles))
        both.sort(key=lambda each: -float(size[each].mean()) if each.any() else 0.0)
        beside = folds & ~(both[0] | both[1])  # creases of what is no grid go with the last
        both[1] = both[1] | beside
        sets = [CreaseLines(*_ends(edges, letters, each)) for each in both if each.any()]
    return HandFolding(
        CreaseLines(*_ends(edges, letters, folds)),
        tuple(sets),
        _sideways(document, document.state(states[-1]).positions),
        states,
    )


def state_between(document: Document, start: str, share: float) -> int:
    """The number of the state that is nearest to a share of the way to the target.

    From the open state where none is flat.
    """
    first = document.named.get(start, document.named.get(OPEN, 0))
    last = document.named.get(SHELL, len(document.states) - 1)
    return first + round(share * (last - first))


def measured(document: Document, which: int | str) -> str:
    """The sides of the box around the sheet in a state, in words."""
    sides = np.ptp(document.state(which).positions, axis=0)
    return box(sides.tolist(), document.unit)


def _ends(edges: Integers, letters: Array, chosen: Booleans) -> tuple[Integers, Integers]:
    return edges[chosen & (letters == "M")], edges[chosen & (letters == "V")]


def _sideways(document: Document, positions: Array) -> bool:
    """Whether the edges that come nearer to each other are left and right in the flat sheet."""
    shape = document.grid_shape
    flat = document.require_flat()
    if shape is None:
        wide, high = np.ptp(flat, axis=0).tolist()
        return bool(wide >= high)
    count = shape[0] * shape[1]
    before, after = flat[:count].reshape(*shape, 2), positions[:count].reshape(*shape, 3)
    left = [
        float(_apart(after, axis) / _apart(before, axis)) for axis in (0, 1)
    ]  # between the first and the last row, and column
    away = before[:, -1].mean(axis=0) - before[:, 0].mean(axis=0)
    columns_across = abs(away[0]) >= abs(away[1])
    return bool(columns_across == (left[1] <= left[0]))


def _apart(grid: Array, axis: int) -> float:
    """Mean distance of opposite vertices of the first and the last line along an axis."""
    first, last = np.take(grid, 0, axis), np.take(grid, -1, axis)
    return float(np.linalg.norm(last - first, axis=-1).mean())
