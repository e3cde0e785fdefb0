"""Sizes of a sheet and of a shell that stands, and the words in which every report has them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.quantities import area, box
from orishell.conventions.row import Row
from orishell.document.document import Document
from orishell.document.measures import BoxReport, SheetReport


def size_rows(
    sheet: SheetReport | None,
    deployed: BoxReport | None,
    outside: BoxReport | None,
    unit: str,
    *,
    boards: bool,
) -> Iterator[Row]:
    """The rows of the verdict that say sizes.

    Parameters
    ----------
    sheet, deployed
        Of the flat sheet, and of what folds; None where there is none.
    outside
        Of that and what is clipped on; None where nothing is.
    unit
        Of length.
    boards
        Whether panels have a thickness.
    """
    if sheet is not None:
        yield Row("says", "sheet", f"{sheet_in_words(sheet, unit)}, area {area(sheet.area, unit)}")
    if deployed is not None:
        words = deployed_in_words(deployed, outside, unit, boards=boards)
        yield Row("says", "deployed", words)


def sheet_in_words(sheet: SheetReport, unit: str) -> str:
    """The sides of a flat sheet, or of the largest of its strips."""
    sides = box((sheet.width, sheet.height), unit)
    return f"{sheet.strips} strips, up to {sides}" if sheet.strips else sides


def deployed_in_words(
    deployed: BoxReport, outside: BoxReport | None, unit: str, *, boards: bool
) -> str:
    """The sides of a shell that stands, each with what it is of.

    Parameters are those of :func:`size_rows`.
    """
    of = "of its boards" if boards else "of panels without a thickness"
    clipped = "" if outside is None else f"; {sides_in_words(outside, unit)} with clipped parts"
    return f"{sides_in_words(deployed, unit)} {of}{clipped}"


def sides_in_words(of: BoxReport, unit: str) -> str:
    """The sides of a box along x, y and z."""
    return box(of.sides, unit)


def rows_of_panels(document: Document) -> tuple[Row, ...]:
    """The rows of a document of which nothing but its panels is known."""
    flat, states = document.flat, document.states
    sheet = None
    if flat is not None:
        width, height = np.ptp(flat, axis=0).tolist()
        sheet = SheetReport(width, height, float(document.areas().sum()))
    deployed = None
    if len(states):
        deployed = BoxReport(*np.ptp(document.shell.positions, axis=0).tolist())
    return tuple(size_rows(sheet, deployed, None, document.unit, boards=False))
