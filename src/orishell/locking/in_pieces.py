"""The path of whole boards, of each piece by itself: no other is near while it folds."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TypeVar

from orishell.clash import PathResult, find_first_contact
from orishell.clash.bodies import Bodies
from orishell.clash.hinged_path import find_first_hinged_contact
from orishell.conventions.progress import Progress, stretch
from orishell.motion import Mechanism
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.boards import Boards
from orishell.motion.hinge_lines import HingeLines
from orishell.motion.layout import Layout
from orishell.motion.piece import SheetPiece
from orishell.solids.hinged.pieces import BuiltPiece, pieces_of

Alone = TypeVar("Alone")


def one_by_one(
    pieces: Sequence[Alone],
    end: float,
    search: Callable[[Alone, float, Progress], PathResult],
    progress: Progress,
) -> PathResult:
    """The first contact in any of the pieces, which are searched one after the other."""
    found = []
    for number, piece in enumerate(pieces):
        own = stretch(progress, number / len(pieces), (number + 1) / len(pieces))
        found.append(search(piece, end, own))
        contact = found[-1].contact
        end = end if contact is None else contact.drive
    return PathResult.of_all(found)


def first_hinged_contact(
    mechanism: Mechanism, boards: Boards, end: float, tolerance: float, progress: Progress
) -> PathResult:
    """The first contact of whole boards and arms, of each piece by itself."""

    def search(piece: BuiltPiece, end: float, progress: Progress) -> PathResult:
        faces = Layout.of(piece.sheet).faces
        bodies = Bodies(piece.boards, faces, panels_laid_flat(piece.sheet))
        result = find_first_hinged_contact(piece.sheet, end, tolerance, bodies, progress)
        met = result.contact
        if met is None or met.bodies is None:
            return result
        panels, numbers = piece.panels[list(met.panels)], piece.numbers[list(met.bodies)]
        named = replace(met, panels=tuple(panels.tolist()), bodies=tuple(numbers.tolist()))
        return replace(result, contact=named)

    return one_by_one(pieces_of(mechanism, boards), end, search, progress)


def first_contact_of_pieces(
    mechanism: Mechanism, hinges: HingeLines, end: float, tolerance: float, progress: Progress
) -> PathResult:
    """The first contact of panels without a thickness, of each piece by itself."""

    def search(rows: slice, end: float, progress: Progress) -> PathResult:
        piece = SheetPiece(mechanism, rows)
        result = find_first_contact(piece, end, tolerance, progress=progress)
        if result.contact is None:
            return result
        first, second = (
            each + rows.start * (piece.grid.columns - 1) for each in result.contact.panels
        )
        return replace(result, contact=replace(result.contact, panels=(first, second)))

    return one_by_one(hinges.pieces_of(mechanism.grid.rows - 1), end, search, progress)
