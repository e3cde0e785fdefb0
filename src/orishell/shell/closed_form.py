"""A followed motion in closed form, where its panels make a grid that has one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.families.drawn import drawn_sheet
from orishell.motion.following import Followed
from orishell.numerics.equals import first_smallest
from orishell.verification.pattern.on_grid import OnGrid

AGREES = 1e-9
"""A closed form that departs from the followed motion by more is not that of this motion (rad)."""


def in_closed_form(motion: Followed) -> Followed | None:
    """The same states with fold angles in closed form; None where that is not known.

    Panels must make a grid of quadrilaterals with inner vertices of degree four. The states are
    those in which the crease that closes first folds as it does in the followed ones.

    Parameters
    ----------
    motion
        The followed motion.
    """
    grid = OnGrid.of(replace(motion.pattern, letters=motion.letters))
    if grid is None:
        return None
    try:
        sheet = drawn_sheet(grid.flat, grid.signs, np.pi)
    except DesignError:
        return None
    driving = first_smallest(np.abs(np.abs(grid.on_edges(sheet.fold_angles(1.0))) - 1.0), size=1.0)
    folds = grid.on_edges(sheet.fold_angles(np.abs(motion.folds[:, driving])))
    return motion.with_folds(folds) if np.abs(folds - motion.folds).max() <= AGREES else None
