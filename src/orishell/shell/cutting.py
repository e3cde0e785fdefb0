"""A shell cut with errors: what the file asks about it, and where its hinges do not allow it.

Limit: errors of cutting, and the play that they ask of hinges, are found to first order. The proof
that nothing touches is for exact boards.
"""

from __future__ import annotations

from collections.abc import Iterator

from orishell.conventions.progress import Progress
from orishell.conventions.quantities import plain, size
from orishell.conventions.row import Note
from orishell.deployment.cutting import CuttingReport, can_measure, measure_cutting
from orishell.deployment.feet import Feet
from orishell.design import Design
from orishell.workshop import Workshop

UP = 1.005
"""A gap that is offered is more than needed, so that three digits of it are not less."""


def find_cutting(
    design: Design, workshop: Workshop, feet: Feet | None, progress: Progress
) -> CuttingReport | None:
    """What errors of cutting do to a shell, if the file asks.

    None otherwise, for whole boards, and for sheets that are too large.

    Raises InputError if they do not fit the sheet.
    """
    if not asks_for_cutting(workshop) or design.has_whole_boards:
        return None
    if not can_measure(design.mechanism):
        return None
    sheet = design.flapped
    cutting = workshop.cutting
    if cutting == "auto":
        cutting = "sheet" if design.panel is None else "boards"
    stands: tuple[tuple[int, int], ...] = ()
    if feet is not None:
        # Clipped flaps are columns of their own.
        before = sheet.inner_columns.start - design.mechanism.inner_columns.start
        vertices = feet.vertices(design.mechanism).tolist()
        stands = tuple((row, column + before) for row, column in vertices)
    return measure_cutting(
        sheet,
        error=workshop.cutting_error,
        bias=workshop.cutting_bias,
        cutting=cutting,
        feet=stands,
        progress=progress,
    )


def asks_for_cutting(workshop: Workshop) -> bool:
    """Whether errors of cutting are given."""
    return bool(workshop.cutting_error or workshop.cutting_bias)


def warn_of_cutting(design: Design, found: CuttingReport | None, unit: str) -> Iterator[str]:
    """Hinges that do not give as much as errors of cutting ask for."""
    if found is None:
        return
    play = size(found.play.largest, unit, bound=True)
    if design.panel is None:
        lift = size(found.lift.largest, unit, bound=True)
        what = "creases" if found.cutting == "sheet" else "hinges"
        yield (
            f"as it is cut, panels part by up to {play} at ends of {what} (in 95 % of sheets): "
            f"where {what} give less, panels bend, and their corners lift by up to {lift}"
        )
    elif design.panel.gap < found.play.largest:
        gap = f"{found.play.largest * UP:.3g}"
        yield Note(
            f"as they are cut, boards need up to {play} of play at their hinges (in 95 % of "
            f"shells), more than the gap between them, {plain(design.panel.gap)} {unit}: cut more "
            f"exactly, or leave at least {gap} {unit} there, if panels have the room",
            "play",
        )
