"""Which sheet a fit begins with: several are tried coarsely, the best is finished."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from orishell.conventions.progress import Progress, no_progress, stretch
from orishell.conventions.record import record
from orishell.design.piece import Piece
from orishell.families.flat_foldable.fit.conditions import Conditions
from orishell.families.flat_foldable.fit.continuation import (
    FAST,
    THOROUGH,
    Begun,
    Course,
    follow,
    settle,
)
from orishell.families.flat_foldable.fit.figures import Reached
from orishell.families.flat_foldable.fit.residuals import Fitted
from orishell.families.flat_foldable.fit.unknowns import Unknowns
from orishell.numerics.equals import smallest_of

SECTOR = 1.1
"""Sector angle of the Miura-ori that a fit begins with (radians)."""
FOLDS = (1.6, -1.6, 1.1)
"""Fold angles of its row creases that are tried (radians); negative, if crests are valleys."""
DIRECTIONS = (0, 90)
"""How far the sheet is turned to the piece (degrees): rows from left to right, or upwards."""
COARSE = 9
"""Sheets with more panels along a side are tried with so many first, or one less."""
SHARE = 0.45
"""Of the work, that the coarse trials are."""
GOOD = (0.005, 0.02)
"""Coarse sheets tell only about which will be nearest. If vertices of the first one that is
finished leave the offset surfaces by more than this share of the diagonal, a second one is; if
those of the second do, a third and last one."""
ALIKE = 0.02
"""Sheets are alike if none of their figures differs by more than this share."""
TIE = 1e-3
"""Coarse sheets whose scores differ by less than this share are equally near."""


@dataclass(frozen=True)
class Start:
    """A Miura-ori on the mean plane of the piece."""

    direction: int  # degrees, counter-clockwise from the piece's rows
    folded: float  # fold angle of its row creases (radians), negative if crests are valleys

    def on(self, piece: Piece) -> Piece:
        """The piece as the sheet sees it."""
        return piece.turned(self.turns)

    @property
    def turns(self) -> int:
        """How often the piece is turned."""
        return self.direction // 90


@record
class Fit:
    """A sheet that was fitted to a piece."""

    start: Start
    of: Unknowns
    fitted: Fitted
    reached: Reached


@record
class Task:
    """What is asked for: a sheet of R x C inner vertices on a piece."""

    piece: Piece
    rows: int
    columns: int
    conditions: Conditions
    straight: bool = False  # whether the right border is straight in the flat sheet

    def tried(
        self, starts: Sequence[Start], course: Course, progress: Progress = no_progress
    ) -> list[Fit | None]:
        """The sheets that starts lead to; None for one that does not keep the conditions itself."""
        with np.errstate(divide="ignore", invalid="ignore"):  # rounding swallows edges
            begun = [Begun(each.turns, self.begun(each)) for each in starts]
        found = follow(self.piece, begun, self.conditions, course, progress)
        return [
            None if fitted is None else Fit(start, each.of, *fitted)
            for start, each, fitted in zip(starts, begun, found, strict=True)
        ]

    def moved(self, fit: Fit) -> Fit | None:
        """The sheet that one fitted to another piece nearby leads to; None where it cannot begin.

        fit: Of as many rows and columns, or it cannot.
        """
        with np.errstate(divide="ignore", invalid="ignore"):
            of = self.begun(fit.start)
        if of.first.shape != fit.of.first.shape or of.shape != fit.of.shape:
            return None
        begun = Begun(fit.start.turns, of)
        found = settle(self.piece, begun, self.conditions, fit.fitted.unknowns)
        return None if found is None else Fit(fit.start, of, *found)

    def begun(self, start: Start) -> Unknowns:
        """What a start is made of."""
        return Unknowns.covering(
            start.on(self.piece),
            self.rows,
            self.columns,
            SECTOR,
            start.folded,
            straight=self.straight,
        )

    def ranked(self, starts: list[Start], progress: Progress) -> list[Start]:
        """Starts, those first that lead nearest with a coarse sheet; of those alike only one.

        Those that lead to none are left out, unless all do.
        """
        coarse, share = self.coarse()
        found = coarse.tried(starts, FAST, progress)
        reached = {start: each.reached for start, each in zip(starts, found, strict=True) if each}
        kept: list[Start] = []
        for start in _order({start: each.score(share) for start, each in reached.items()}):
            if not any(_alike(reached[start], reached[other]) for other in kept):
                kept.append(start)
        return kept or starts

    def coarse(self) -> tuple[Task, float]:
        """The task with fewer panels, and how much larger these are."""
        panels = self.rows + 1, self.columns + 1
        share = max(1.0, max(panels) / COARSE)
        small = [min(each, max(4, round(each / share))) for each in panels]
        # Odd numbers of panels stay odd: then there are crests at both ends, or there are not.
        rows, columns = (each - (each - of) % 2 - 1 for each, of in zip(small, panels, strict=True))
        return replace(self, rows=rows, columns=columns), share


def _order(scores: Mapping[Start, float]) -> list[Start]:
    """Those of the least score first; of those that are as good the first.

    Starts that symmetry makes alike differ by rounding, and by how the surface is given.
    """
    left, found = dict(scores), list[Start]()
    while left:
        least = min(left.values())
        found.append(next(each for each, score in left.items() if score <= (1 + TIE) * least))
        del left[found[-1]]
    return found


def _alike(one: Reached, other: Reached) -> bool:
    return np.allclose(one.figures, other.figures, rtol=ALIKE, atol=0)


def fit_sheet(
    task: Task,
    *,
    direction: int | None = None,
    folded: float | None = None,
    progress: Progress = no_progress,
) -> Fit | None:
    """The sheet that comes nearest to a piece; None if there is none that keeps the conditions.

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
        starts = task.ranked(starts, stretch(progress, 0, SHARE))
    finished: list[Fit] = []
    limits = (*GOOD, np.inf)
    for number, (start, good) in enumerate(zip(starts, limits, strict=False)):
        begun = SHARE + (1 - SHARE) * number / len(limits)
        told = stretch(progress, begun, begun + (1 - SHARE) / len(limits))
        (found,) = task.tried([start], THOROUGH, told)
        if found is not None:
            finished.append(found)
            if found.reached.vertices <= good:
                break
    return smallest_of(finished, lambda each: each.reached.score()) if finished else None
