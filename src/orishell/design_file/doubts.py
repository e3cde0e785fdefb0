"""Whether a mesh that does not say its unit was drawn in another one than the design's."""

from __future__ import annotations

from typing import Final

import numpy as np

from orishell.conventions.quantities import MILLIMETRES, Unit, box, conversion
from orishell.design import MeshSurface, PiecedSurface

NARROWEST, WIDEST = 50.0, 500e3
"""Diagonals (millimetres) beyond which a shell is not likely to be meant: the widest roofs without
supports span 300 m, and models of card are larger than a stamp."""
LIKELY = 500.0, 200e3
"""Diagonals (millimetres) that are: a unit that leads there is asked about."""
DRAWN_IN: Final[tuple[Unit, ...]] = ("mm", "m", "cm", "in", "ft")
"""Units of other programs, the most frequent first."""


def likely_unit(surface: PiecedSurface | None, unit: str) -> Unit | None:
    """The unit that a mesh was drawn in, by its size in the design's; None if there is no doubt."""
    if not isinstance(surface, MeshSurface) or surface.unit:
        return None
    size = surface.size()
    if NARROWEST <= size * MILLIMETRES[unit] <= WIDEST:
        return None
    for each in DRAWN_IN:
        if LIKELY[0] <= size * MILLIMETRES[each] <= LIKELY[1]:
            return each
    return None


def doubts_of(surface: PiecedSurface | None, unit: str, *, sized: bool) -> tuple[str, ...]:
    """The question which unit a mesh was drawn in, if there is doubt.

    sized: Whether the target is scaled to sizes that are asked for, so that its own do not matter.
    """
    drawn = likely_unit(surface, unit)
    if drawn is None or surface is None or sized:
        return ()
    asked = (
        f"the mesh is {in_plan(surface, unit)} in plan, as its file names no unit: "
        f'was it drawn in {drawn}? unit = "{drawn}" in [target.surface] makes it '
        f"{in_plan(surface, unit, conversion(drawn, unit))}"
    )
    return (asked,)


def in_plan(surface: PiecedSurface, unit: str, factor: float = 1.0) -> str:
    """Sizes of a surface along x and y, enlarged, in words."""
    return box((factor * np.ptp(surface.piece.vertices, axis=0)[:2]).tolist(), unit)
