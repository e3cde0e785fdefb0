"""Plates in folds of a shell, gussets or those of box girders: where they fit, what they hold."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from orishell.conventions.errors import DesignError, InputError
from orishell.design import Design
from orishell.design.design import Fixing, warn_of_no_lock
from orishell.design.part import Part
from orishell.motion.freedom import held_at, hold_alone
from orishell.numerics.arrays import Integers

SHALLOW = 1e-3
"""A crease that folds by an angle with a smaller sine has no fold for a plate (radians)."""


def require_creases(design: Design, what: str) -> None:
    """Refuse whole boards, whose hinges are not in creases.

    what: What cannot be put into them, in the plural.
    """
    if design.has_whole_boards:
        raise InputError(
            f"{what} go along creases, and whole boards have their hinges beside these",
            keys=("stiffeners", "panel.construction"),
            got='"hinged"',
            expected='"sandwich" or "bevel"',
        )


def require_folds(design: Design, at: Integers, what: str) -> None:
    """Refuse plates at vertices where the creases of the row do not fold, or are shut."""
    mechanism = design.mechanism
    folds = np.sin(mechanism.fold_angles(mechanism.target_drive).row)
    padded = np.pad(folds, ((0, 0), (1, 1)), constant_values=1.0)
    row, column = at.T
    least = np.minimum(np.abs(padded[row - 1, column]), np.abs(padded[row - 1, column + 1]))
    if (least < SHALLOW).any():
        worst = at[int(np.argmin(least))].tolist()
        raise DesignError(
            f"there is no fold for a {what}",
            place=f"at vertex {worst[0]}, {worst[1]}",
            keys=("stiffeners.rows", "stiffeners.columns"),
            size="creases of its row are flat there, or shut",
        )


def with_plates(design: Design, at: Integers, parts: Iterable[Part]) -> Design:
    """The design with plates at vertices (G, 2), and what they hold; then it lacks no lock."""
    fixed_by, bare = _held_by_plates(design, at), warn_of_no_lock(0.0)
    warnings = tuple(each for each in design.warnings if fixed_by is None or each not in bare)
    return replace(
        design, attached=(*design.attached, *parts), fixed_by=fixed_by, warnings=warnings
    )


def _held_by_plates(design: Design, at: Integers) -> Fixing | None:
    """Whether gussets, or plates of boxes, at vertices (G, 2) keep the whole sheet still.

    A gusset keeps the angle between two edges of the column. With it about its vertex there are two
    triangles on a sphere whose three sides are fixed, so that no crease there turns: at a vertex on
    the border there is one. They are no straight arcs, as creases of the row are neither flat nor
    shut.
    """
    mechanism = design.mechanism
    vertices = at[:, 0] * mechanism.grid.columns + at[:, 1]
    if hold_alone(mechanism, vertices).all():
        return "any"
    return "all" if held_at(mechanism, vertices) else None
