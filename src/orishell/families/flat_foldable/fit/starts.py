"""Which sheet a fit begins with: several are tried coarsely, the best is finished."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

import numpy as np

from orishell.conventions.progress import Progress, no_progress, stretch
from orishell.conventions.record import record
from orishell.design.piece import Piece
from orishell.families.flat_foldable.fit.conditions import Conditions
from orishell.families.flat_foldable.fit.course import FAST, THOROUGH, Course, follow
from orishell.families.flat_foldable.fit.figures import Reached
from orishell.families.flat_foldable.fit.residuals import Fitted
from orishell.families.flat_foldable.fit.unknowns import Unknowns

SECTOR = 1.1
"""Sector angle of the Miura-ori that a fit begins with (radians)."""
FOLDS = (1.6, 1.1)
"""Fold angles of its row creases that are tried (radians)."""
DIRECTIONS = (0, 90)
"""How far the sheet is turned to the piece (degrees): rows from left to right, or upwards."""
COARSE = 9
"""Sheets with more panels along a side are tried with so many first, or one less."""
SHARE = 0.45
"""Of the work, that the coarse trials are."""
WHAT = "fitting the sheet"


@dataclass(frozen=True)
class Start:
    """A Miura-ori on the mean plane of the piece."""

    direction: int  # degrees, counter-clockwise from the piece's rows
    folded: float  # fold angle of its row creases (radians), negative if crests are valleys

    def on(self, piece: Piece) -> Piece:
        """The piece as the sheet sees it."""
        for _ in range(self.direction // 90):
            piece = piece.turned()
        return piece


@record
class Fit:
    """A sheet that was fitted to a piece."""

    start: Start
    of: Unknowns
    fitted: Fitted
    reached: Reached


def fit_sheet(
    piece: Piece,
    rows: int,
    columns: int,
    conditions: Conditions,
    *,
    direction: int | None = None,
    folded: float | None = None,
    progress: Progress = no_progress,
) -> Fit | None:
    """The sheet of R x C inner vertices that comes nearest to a piece; None if there is none.

    Parameters
    ----------
    direction
        How far its rows are turned to those of the piece (a multiple of 90 degrees); None for
        what comes nearest.
    folded
        Fold angle of the row creases it begins with (radians); None for what leads nearest.
    """
    starts = [
        Start(way, fold)
        for way, fold in product(
            DIRECTIONS if direction is None else (direction,),
            FOLDS if folded is None else (folded,),
        )
    ]
    if len(starts) > 1:
        starts = _ranked(piece, rows, columns, conditions, starts, stretch(progress, 0, SHARE))
    finishing = stretch(progress, SHARE, 1)
    for start in starts:
        found = _tried(piece, rows, columns, conditions, start, THOROUGH, finishing)
        if found is not None:
            return found
    return None


def _ranked(
    piece: Piece,
    rows: int,
    columns: int,
    conditions: Conditions,
    starts: list[Start],
    progress: Progress,
) -> list[Start]:
    """Starts, those first that lead nearest with a coarse sheet."""
    coarse, share = _coarse(rows, columns)
    scores = []
    for number, start in enumerate(starts):
        found = _tried(piece, *coarse, conditions, start, FAST)
        scores.append(np.inf if found is None else found.reached.score(share))
        progress((number + 1) / len(starts), WHAT)
    return [starts[k] for k in np.argsort(scores, kind="stable")]


def _coarse(rows: int, columns: int) -> tuple[tuple[int, int], float]:
    """Inner vertices of a sheet of about the same shape, and its panels' size to the others'."""
    share = max(1.0, (max(rows, columns) + 1) / COARSE)
    small = [max(4, round((each + 1) / share)) for each in (rows, columns)]
    # Odd numbers of panels stay odd: crests at both ends, or not.
    small = [
        min(each, of + 1) - (each - of - 1) % 2
        for each, of in zip(small, (rows, columns), strict=True)
    ]
    return (small[0] - 1, small[1] - 1), share


def _tried(
    piece: Piece,
    rows: int,
    columns: int,
    conditions: Conditions,
    start: Start,
    course: Course,
    progress: Progress = no_progress,
) -> Fit | None:
    seen = start.on(piece)
    of = Unknowns.covering(seen, rows, columns, SECTOR, start.folded)
    found = follow(seen, of, conditions, course, progress)
    return None if found is None else Fit(start, of, *found)
