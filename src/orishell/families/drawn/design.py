"""The design of a drawn sheet: its mechanism, or how far it is from folding (not in the paper)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import in_degrees, rounded, tidy_degrees
from orishell.conventions.quantities import plain
from orishell.design import Design, Parameter
from orishell.families.drawn.decided import decide, end_of, nearby_as_drawn
from orishell.families.drawn.mechanism import DrawnSheet
from orishell.families.drawn.nearest import DRIVES, MOST_MOVED
from orishell.families.drawn.sheet import drawn_sheet
from orishell.families.drawn.signs import MOST_WAYS, ROUNDED
from orishell.families.shared.axes import axes_of
from orishell.motion import drive_at_fold, largest_fold, require_resolution
from orishell.motion.drawing import Drawing
from orishell.motion.following.rigid import why_still
from orishell.motion.grid import CreaseValues
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_largest

MOVED = 1e-3
"""Vertices are moved by this share of the shortest edge where the file does not say how far."""


def design_drawn(drawing: Drawing, *, fold: float | None, move: float | None) -> Design:
    """Design the shell of a drawn sheet.

    Parameters
    ----------
    drawing
        The sheet.
    fold
        The largest fold angle at the target, in (0, pi] (radians); None for as far as the sheet
        folds.
    move
        How far vertices may be moved so that the sheet folds exactly (length); None for a
        thousandth of the shortest edge.

    Raises
    ------
    DesignError
        If it does not fold: by how much, where, and how far vertices have to be moved.
    """
    pattern = drawing.pattern
    still = why_still(pattern, ROUNDED * pattern.diagonal / drawing.shortest)
    if still:
        raise DesignError("the sheet does not fold as its letters ask", size=f"proved: {still}")
    decided = decide(drawing.flat, drawing.signs)
    if decided is None:
        raise DesignError(
            "no mountains and valleys were found with which the sheet folds",
            size=_without_letters(drawing),
        )
    sheet, signs, end = decided.sheet, decided.ways[0], decided.end
    warnings = (*drawing.notes, *_of_letters(drawing, decided.ways))
    moved = 0.0
    if not decided.exact:
        flat, moved = _folding(
            drawing, signs, sheet, MOVED * drawing.shortest if move is None else move
        )
        sheet = drawn_sheet(flat, signs, np.pi)
        end = end_of(sheet)
        warnings += (
            f"as drawn the sheet folds only nearly: vertices are moved by up to {plain(moved, 2)} "
            "so that it folds exactly",
        )
    asked = np.pi if fold is None else drive_at_fold(sheet, fold)
    sheet = replace(sheet, fold=min(asked, end), end=end)
    return _design(sheet, moved, warnings, open_ended=fold is None)


def _without_letters(drawing: Drawing) -> str:
    """How many creases have none; empty if all have one."""
    signs = drawing.signs
    missing = int(np.isnan(signs.row).sum() + np.isnan(signs.column).sum())
    if not missing:
        return ""
    return f"{missing} of {signs.row.size + signs.column.size} creases have no letter"


def _of_letters(drawing: Drawing, ways: tuple[CreaseValues, ...]) -> tuple[str, ...]:
    """What is to be said of letters that were found."""
    creases = _without_letters(drawing)
    if not creases:
        return ()
    flat = any((each.row == 0).any() or (each.column == 0).any() for each in ways)
    count = f"{len(ways)} ways" + (" or more" if len(ways) == MOST_WAYS or flat else "")
    several = f" and the first of {count} to fold the sheet is taken" if len(ways) > 1 else ""
    return (f"{creases}: mountains and valleys were found{several}",)


def _folding(
    drawing: Drawing, signs: CreaseValues, sheet: DrawnSheet, most: float
) -> tuple[Array, float]:
    """A sheet nearby that folds, and how far its vertices are moved."""
    apart = np.abs(sheet.drive.disagreement(DRIVES)).max(axis=-1)
    apart = np.where(np.isfinite(apart), apart, np.pi)
    row, column = np.unravel_index(first_largest(apart), apart.shape)
    nearby = nearby_as_drawn(drawing.flat, signs, sheet)
    found = None if nearby is None else nearby.vertices
    size = f"fold angles there disagree by {in_degrees(float(apart.max()))} degrees"
    if found is None:
        size += f"; no sheet nearby was found that folds, looked for up to {MOST_MOVED} vertices"
    else:
        moved = float(np.linalg.norm(found - drawing.flat, axis=-1).max())
        if moved <= most:
            return found, moved
        size += f"; it folds with vertices moved by up to {plain(moved)}"
    raise DesignError(
        "the sheet as drawn does not fold with rigid panels",
        keys=("pattern.move",),
        place=f"worst at vertex {row + 1}, {column + 1}",
        size=size,
        candidates=[] if found is None else [Remedy({"pattern.move": rounded(1.01 * moved)})],
        excess=float(apart.max()) / np.pi,
    )


def _design(
    sheet: DrawnSheet, moved: float, warnings: tuple[str, ...], *, open_ended: bool
) -> Design:
    require_resolution(sheet, [])
    sheet = levelled(sheet)
    described: dict[str, Parameter] = {
        "fold_deg": tidy_degrees(float(largest_fold(sheet, np.array([sheet.fold]))[0])),
        "moved": moved,
        "flap": 0.0,
    }

    def ending_at(drive: float) -> Design:
        return _design(replace(sheet, fold=drive), moved, warnings, open_ended=True)

    return Design(
        mechanism=sheet,
        parameters=described,
        targets={},
        closeness={},
        swept=None,
        warnings=warnings,
        may_stand=True,
        ending_at=ending_at if open_ended else None,
    )


def levelled(sheet: DrawnSheet) -> DrawnSheet:
    """The sheet level at its target, turned no more than that takes.

    If its first and last rows can then be its lowest, they are at one height: it stands on them.
    """
    still = sheet.least_turning
    shell = still.positions(still.target_drive)
    along, _, normal = axes_of(shell)
    ends = np.cross(along, (shell[0] - shell[-1]).mean(axis=0))
    heights = (shell @ ends).mean(axis=1)
    if heights[1:-1].min() > max(heights[0], heights[-1]):
        normal = ends / np.linalg.norm(ends)
    axis = np.array([normal[1], -normal[0], 0.0])
    sine = float(np.hypot(*axis[:2]))
    if sine == 0:
        return sheet
    return replace(sheet, turn=axis / sine * float(np.arctan2(sine, normal[2])))
