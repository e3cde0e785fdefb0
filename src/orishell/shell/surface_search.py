"""Few panels whose shell comes near enough to a surface: the fewest of the sizes that are tried.

Each size is a fit of its own, which takes seconds: so only sizes of the surface's own proportions
are tried, and few of them. A corrugation of panels half as large is half as deep, so that the
distance tells about how many are needed; from there it is narrowed down from both sides.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

from orishell.conventions.errors import DesignError
from orishell.conventions.progress import Progress, stretch
from orishell.families.tolerance import Tolerance
from orishell.numerics.equals import smallest_of
from orishell.shell.board_limits import BoardFit, refuse_boards
from orishell.shell.size_trials import CHOOSING, Choice, Trial, refuse_distance, unbeaten

FIRST, FEWEST_PANELS, MOST_PANELS = 8, 4, 32
"""Panels along the longer side of the surface: at first, at least and at most."""
FITS = 9
"""Sizes that are tried, at most."""
GROWTH = 1.5
"""From a size that was refused to the next."""
SAFE = 1.05
"""An error that is allowed in a remedy, relative to the smallest found."""

Measure = Callable[[int, int, Progress], tuple[Trial, BoardFit]]
"""A trial of so many rows and columns, and what its boards are like."""


@dataclass(slots=True, eq=False)
class SurfaceSearch:
    """Looks for few panels: of the sizes that it tries, the fewest that do."""

    measure: Measure
    extents: tuple[float, float]  # of the surface, to the right and upwards (lengths)
    tolerance: Tolerance
    progress: Progress
    made: list[Trial] = field(default_factory=list)
    # those that do, but for the share or the chamfers of their boards
    bare: list[tuple[Trial, BoardFit]] = field(default_factory=list)
    refusal: DesignError | None = None  # the first

    def run(self) -> Choice:
        """Choose a size.

        Raises DesignError if none meets the tolerance; says what can be met.
        """
        low, high, count = FEWEST_PANELS - 1, MOST_PANELS + 1, FIRST
        chosen: Trial | None = None
        for number in range(FITS):
            told = stretch(self.progress, number / FITS, (number + 1) / FITS)
            trial, excess, small = self._tried(count, told)
            if excess > 1:
                low = max(low, count)
            if small > 1 or excess <= 1:  # panels of finer sheets are smaller still
                high = count
            if max(excess, small) <= 1:
                chosen = trial
            if high - low <= 1:
                break
            wanted = count * (excess if math.isfinite(excess) else GROWTH)
            count = min(max(math.ceil(wanted), low + 1), high - 1)
        if chosen is None:
            raise self._refused()
        self.progress(1.0, CHOOSING)
        limits = self.tolerance
        bare = [trial for trial, _ in self.bare]
        fitting = [
            each
            for each in self.made
            if limits.allows(each.shortest, each.longest) and each not in bare
        ]
        return Choice(chosen, unbeaten(fitting), len(self.made), limits)

    def shape(self, count: int) -> tuple[int, int]:
        """Rows and columns of inner vertices for so many panels along the longer side."""
        right, up = self.extents
        longer = max(right, up)
        rows, columns = (
            max(FEWEST_PANELS, round(count * each / longer)) - 1 for each in (up, right)
        )
        return rows, columns

    def _tried(self, count: int, progress: Progress) -> tuple[Trial | None, float, float]:
        """A trial, and the factors by which it is off and its panels are too small.

        The first is infinite where it is refused.
        """
        try:
            trial, boards = self.measure(*self.shape(count), progress)
        except DesignError as error:
            self.refusal = self.refusal or error
            return None, math.inf, 0.0
        self.made.append(trial)
        limits = self.tolerance
        short = limits.panel_min / trial.shortest
        excess = max(
            trial.error / limits.surface, trial.longest / limits.panel_max, boards.oversize
        )
        if max(excess, short) <= 1 < boards.misses(limits):
            self.bare.append((trial, boards))
        return trial, max(excess, boards.steep(limits)), max(short, boards.bare(limits))

    def _refused(self) -> DesignError:
        if not self.made:
            assert self.refusal is not None
            return self.refusal
        limits = self.tolerance
        if self.bare:
            nearest, boards = smallest_of(self.bare, lambda each: each[1].misses(limits))
            return refuse_boards(nearest.rows, nearest.columns, limits, boards)
        nearest = smallest_of(self.made, lambda each: each.error)
        return refuse_distance(
            nearest, limits, "was found", f"{MOST_PANELS} panels along a side", SAFE * nearest.error
        )
