"""A sheet spread over pages of paper that overlap: scale, pages and register marks."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.workshop.settings import Auto, Paper

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

PAPERS_MM: dict[Paper, tuple[float, float]] = {"A4": (210.0, 297.0), "A3": (297.0, 420.0)}
"""Width and height of upright pages."""
BORDER_MM = 10.0
"""What printers leave white along the edges."""
FOOT_MM = 12.0
"""Height of the words below the sheet."""
OVERLAP_MM = 10.0
"""Width of the strip that neighbouring pages share."""
LONGEST = 3
"""Pages along the longer side of the model, if the scale is chosen."""
MOST_PAGES = 400
"""More pages are refused."""
LARGEST_MM = 1e14
"""Larger sheets are refused: no scale that is tried would do."""


@dataclass(frozen=True, slots=True)
class Page:
    """One page of the model."""

    # where it lies, from 1, the first row at the top
    row: int
    column: int
    # lower left corner of its frame on the model (mm on paper)
    left: float
    bottom: float


@record
class Tiling:
    """The model on its pages; lengths in mm on paper, from the lower left corner of the model."""

    scale: float  # size of the model relative to the sheet
    page_width: float
    page_height: float
    # the part of a page that shows the model
    frame_width: float
    frame_height: float
    pages: tuple[Page, ...]  # row by row; those that would be empty are left out

    def marks(self, page: Page) -> Array:
        """Register marks (k, 2) of a page: the corners of what it shares with each neighbour."""
        others = {(other.row, other.column): other for other in self.pages}
        found: list[tuple[float, float]] = []
        for row, column in ((0, -1), (-1, 0), (0, 1), (1, 0)):
            other = others.get((page.row + row, page.column + column))
            if other is None:
                continue
            left, right = sorted((page.left, other.left))
            bottom, top = sorted((page.bottom, other.bottom))
            found += [
                (x, y)
                for x in (right, left + self.frame_width)
                for y in (top, bottom + self.frame_height)
            ]
        return np.array(sorted(set(found))).reshape(-1, 2)


def tile_sheet(outlines: tuple[Array, ...], scale: float | Auto, paper: Paper) -> Tiling:
    """Choose the scale and spread the model over pages, upright or lying, whichever needs fewer.

    outlines: Closed polylines (k, 2) around the sheet and its holes at its true size (mm), from (0,
        0).
    scale: "auto" takes the largest of 1:1, 1:2, 1:2.5, 1:5, 1:10, ... that takes no more than three
        pages either way.

    Raises InputError if a given scale needs more than 400 pages, or the sheet is larger than all
    measure.
    """
    size = np.max([outline.max(axis=0) for outline in outlines], axis=0)
    _require_measure(size)
    upright = PAPERS_MM[paper]
    ways = upright, upright[::-1]
    if scale == "auto":
        size_of = next(
            s for s in _scales() if any(max(_count(size * s, page)) <= LONGEST for page in ways)
        )
    else:
        size_of = float(scale)
    fewest = min(math.prod(_count(size * size_of, page)) for page in ways)
    if fewest > MOST_PAGES:
        raise InputError(
            f"the paper model needs more than {MOST_PAGES} pages",
            keys=("workshop.paper_scale",),
            got=f"{size_of:g}, {fewest} pages",
            expected='a smaller number, or "auto"',
        )
    shape = _shape(tuple(outline * size_of for outline in outlines))
    tilings = [_tile(size * size_of, shape, size_of, page) for page in ways]
    return min(tilings, key=lambda tiling: len(tiling.pages))


STEPS = (1, 2, 2.5, 5)
"""Scales that are tried are 1:1, 1:2, ..., and their tenths."""
WHOLE_FROM = 10
"""Scales from 1:10 on are whole numbers, larger ones have a decimal."""


def page_scale(outlines: tuple[Array, ...], paper: Paper) -> float:
    """The largest scale at which a sheet fits one page, either way: 1:1, 1:2.4, 1:72.

    outlines: As for :func:`tile_sheet`.

    Raises InputError if the sheet is larger than all measure.
    """
    size = np.max([outline.max(axis=0) for outline in outlines], axis=0)
    _require_measure(size)
    upright = PAPERS_MM[paper]
    least = min(float((size / _frame(page)).max()) for page in (upright, upright[::-1]))
    steps = 1 if least > WHOLE_FROM else 10
    return 1 / max(1.0, math.ceil(least * steps - 1e-9) / steps)


def _scales() -> Iterator[float]:
    return (1 / (10.0**power * step) for power in range(16) for step in STEPS)


def _require_measure(size: Array) -> None:
    if max(size) > LARGEST_MM:
        raise InputError(
            "the sheet is too large for a paper model", got=f"{plain(max(size), 3)} mm"
        )


def _frame(page: tuple[float, float]) -> Array:
    return np.array([page[0] - 2 * BORDER_MM, page[1] - 2 * BORDER_MM - FOOT_MM])


def _count(size: Array, page: tuple[float, float]) -> tuple[int, int]:
    """Columns and rows of pages."""
    counts = np.ceil((size - OVERLAP_MM) / (_frame(page) - OVERLAP_MM) - 1e-9)
    columns, rows = np.maximum(counts, 1).astype(int).tolist()
    return columns, rows


def _shape(outlines: tuple[Array, ...]) -> BaseGeometry:
    import shapely

    shape: BaseGeometry = shapely.Polygon(outlines[0])
    for outline in outlines[1:]:
        shape = shapely.symmetric_difference(shape, shapely.Polygon(outline))
    return shape


def _tile(size: Array, shape: BaseGeometry, scale: float, page: tuple[float, float]) -> Tiling:
    import shapely

    frame = _frame(page)
    columns, rows = _count(size, page)
    step = frame - OVERLAP_MM
    begin = 0.5 * (size - (np.array([columns, rows]) * step + OVERLAP_MM))
    pages = []
    for row in range(rows):
        for column in range(columns):
            left, bottom = (begin + step * np.array([column, rows - 1 - row])).tolist()
            box = shapely.box(left, bottom, left + frame[0], bottom + frame[1])
            if shapely.intersects(shape, box):
                pages.append(Page(row + 1, column + 1, left, bottom))
    wide, high = frame.tolist()
    return Tiling(scale, *page, wide, high, tuple(pages))
