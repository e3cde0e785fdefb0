"""The fewest panels that meet a tolerance: rows, columns and what else the design leaves open.

Neither rows nor columns nor what is "auto" bring a shell nearer to its surface in every case, and
nothing is known of a design before it is made, but two distances: a column is as far from f, and
the middle row as far from g, as the shell is from its surface, or nearly. So sizes with fewer
panels than the best one so far are tried row by row, those left out that f or g rules out, and
those with fewer columns than one that is off by far.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import product, repeat
from typing import Generic, TypeVar

from orishell.conventions.errors import DesignError
from orishell.conventions.progress import Progress, no_progress
from orishell.families.tolerance import Tolerance
from orishell.numerics.equals import smallest_of
from orishell.shell.board_limits import refuse_boards
from orishell.shell.size_trials import (
    CHOOSING,
    GIVEN_UP,
    NEAR,
    Choice,
    Sizes,
    Trial,
    Trials,
    Tried,
    refuse_distance,
    unbeaten,
)

GROWTH = 1.6
"""Factor from one size to the next in the first, coarse search."""
STALE = 3
"""Steps of the coarse search that come no nearer, after which it is given up."""
NEARLY = 1.5
"""Sheets off by so much are worth trying unlike rows and columns for."""
FEW_PANELS = 40
"""Where none is found, all sizes of up to so many panels are tried at least."""
REFUSALS, CROSSED = 12, 60
"""Refused designs in a row, and designs in all, after which long and short panels are given up."""
CALM = 10
"""From so many columns on errors rise and fall the less with their number, the more there are."""
ALMOST = 1.02
"""Boards that are off by this factor more than the best, of fewer panels, are offered instead."""
NEARER, MANY = 1.1, 500
"""Tolerance that may be met where one is not, relative to the smallest error found of sheets of at
most so many panels, so that the whole shell can be tried; of the smallest of all, if these are
not."""

V = TypeVar("V")


def choose(
    sizes: Sizes[V], tolerance: Tolerance, progress: Progress = no_progress
) -> tuple[V, Choice]:
    """Find the variant and the size with the fewest panels that meet a tolerance.

    Raises DesignError if no sheet meets the tolerance; says what can be met.
    """
    return SizeSearch(Trials(sizes, tolerance, progress)).run()


def size_ladder(most: int) -> tuple[list[int], list[int]]:
    """Rows and columns of ever finer sheets, up to ``most``."""
    sizes = [2.0 * GROWTH**k for k in range(1, 10)]
    sizes = [size for size in sizes if size < most] + [float(most)]
    return [_odd(size) for size in sizes], [round(size) for size in sizes]


@dataclass(slots=True, eq=False)
class SizeSearch(Generic[V]):
    """Looks for a sheet that does, then for all with fewer panels that may."""

    trials: Trials[V]
    # what is known of numbers of rows and columns with all variants
    known: dict[tuple[int, int], Tried[V]] = field(default_factory=dict)
    impossible: list[int] = field(default_factory=list)  # numbers of rows without any sheet
    few: int = FEW_PANELS  # panels up to which all sizes are tried while none is found
    least: float = math.inf  # smallest factor by which a sheet of the ladders is off

    def run(self) -> tuple[V, Choice]:
        """Choose a variant and a size."""
        trials = self.trials
        while True:
            self._look()
            if self._all_too_long():
                raise self._refused()
            if not trials.found and not any(trials.fits(each) for _, each in trials.made):
                trials.bounded = False  # f or g rule out all that fit: how near do these come?
                self._look()
                trials.bounded = not trials.found
            # Coarser sheets than the first whose boards are not as asked may have more board.
            self.few = max(FEW_PANELS, min((each.panels for _, each, _ in trials.bare), default=0))
            self.impossible.clear()
            for rows in self._rows():
                self._fewest_columns(rows)
            if not trials.found:
                raise self._refused()
            variant, quick = self._best()
            trial = trials.carefully(variant, quick)
            if trials.does(trial):
                break
            trials.found.remove((variant, quick))
            self.known.pop((quick.rows, quick.columns), None)
            trials.careful = True
        trials.progress(1.0, CHOOSING)
        fitting = [trial if each is quick else each for each in trials.fitting()]
        return variant, Choice(trial, unbeaten(fitting), len(trials.made), trials.tolerance)

    @property
    def below(self) -> int:
        """Sheets with fewer panels than this are looked for."""
        return self._best()[1].panels if self.trials.found else self.few + 1

    def _best(self) -> tuple[V, Trial]:
        return min(self.trials.found, key=lambda each: each[1].panels)

    def _look(self) -> None:
        """Look for any sheet that does, along ladders of ever finer ones first."""
        rows, columns = size_ladder(self.trials.sizes.most)
        # Where g is straight more columns are of no use.
        for ladder in (zip(rows, repeat(2)), zip(rows, columns, strict=True)):
            if not self.trials.found:
                self._climb(ladder)
        if not self.trials.found and (self.trials.tolerance.panel_min or self.least <= NEARLY):
            self._cross()

    def _climb(self, ladder: Iterable[tuple[int, int]]) -> None:
        """Try the sheets of a ladder until one does, or finer ones come no nearer."""
        least, stale = math.inf, 0
        for rows, columns in ladder:
            if self.trials.bounded and not self.trials.within_reach(columns):
                continue
            tried = self.trials.make(rows, columns, widely=False)
            if tried.variant is not None:
                return
            stale = 0 if tried.off < 0.9 * least else stale + 1
            least = min(least, tried.off)
            self.least = min(self.least, least)
            if math.isfinite(least) and (stale == STALE or tried.small > 1):
                return

    def _cross(self) -> None:
        """Unlike rows and columns: long panels may do where square ones are too small."""
        rows, columns = size_ladder(self.trials.sizes.most)
        small: list[tuple[int, int]] = []
        refused = 0
        for place in sorted(product([1, *rows], columns), key=math.prod):
            if self.trials.found or refused == REFUSALS or len(self.trials.made) > CROSSED:
                return
            if any(place[0] >= m and place[1] >= n for m, n in small):
                continue
            if not self.trials.bounded or self.trials.within_reach(place[1]):
                tried = self.trials.make(*place, widely=False)
                refused = refused + 1 if tried.off == math.inf else 0
                if tried.small > 1:
                    small.append(place)

    def _all_too_long(self) -> bool:
        """Whether edges are too long in all sheets: sheets with few panels have longer ones."""
        longest = self.trials.tolerance.panel_max
        return bool(self.trials.made) and all(
            each.longest > longest for _, each in self.trials.made
        )

    def _rows(self) -> Iterator[int]:
        """Numbers of rows for which there may be fewer panels, those of the best one first."""
        fewest = self._fewest_of_all()
        left = set(range(1, min(self.trials.sizes.most, self.below) + 1, self.trials.sizes.step))
        while left:
            best = self._best()[1].rows if self.trials.found else 0
            rows = min(left, key=lambda rows: (abs(math.log((rows + 1) / (best + 1))), rows))
            left.remove(rows)
            hopeless = len(self.impossible) >= GIVEN_UP and rows > max(self.impossible[:GIVEN_UP])
            if (rows + 1) * (fewest - 1) < self.below and not hopeless:
                yield rows

    def _fewest_of_all(self) -> int:
        """The fewest columns that g allows."""
        high = 2
        while high < self.trials.sizes.most and not self.trials.within_reach(high):
            high = min(2 * high, self.trials.sizes.most)
        return _first_between(high // 2, high, self.trials.within_reach) if high > 2 else 2

    def _fewest_columns(self, rows: int) -> None:
        """Find the fewest columns of so many rows that do, if that saves panels."""
        fewest = self._fewest_of_all()
        most = min((self.below - 1) // (rows + 1) + 1, self.trials.sizes.most)
        if most < fewest or self._tried(rows, fewest).variant is not None:
            return
        if self._leaves_no_hope(most, self._tried(rows, most).off):
            return
        if min(self._tried(rows, each).off for each in (fewest, most)) == math.inf:
            self.impossible.append(rows)

        def near(columns: int) -> bool:
            return self._tried(rows, columns).off <= self._ripple(columns)

        for columns in range(_first_between(fewest, most, near), most):
            tried = self._tried(rows, columns)
            if tried.variant is not None or (tried.off < 1 / NEAR and tried.small > NEAR):
                return

    def _tried(self, rows: int, columns: int) -> Tried[V]:
        """What was found out of a size, with all variants that may do."""
        place = rows, columns
        if place not in self.known:
            self.known[place] = self._ruled_out(*place) or self.trials.make(*place, widely=True)
        return self.known[place]

    def _ruled_out(self, rows: int, columns: int) -> Tried[V] | None:
        """What was found out of a finer sheet, if that is too far off for this one to do."""
        for (more, others), tried in self.known.items():
            finer = others >= columns and (
                more == rows or (self.trials.sizes.orderly and more >= rows)
            )
            if finer and self._leaves_no_hope(others, tried.off):
                return tried
        return None

    def _leaves_no_hope(self, columns: int, off: float) -> bool:
        """Whether a sheet is too far off for one with fewer columns to do."""
        return self._ripple(columns) < off < math.inf

    def _ripple(self, columns: int) -> float:
        """By which factor sheets with fewer columns may be nearer: by less if these are many."""
        return 1 + (self.trials.sizes.ripple - 1) * min(1.0, CALM / columns)

    def _refused(self) -> DesignError:
        """The error for a tolerance that cannot be met, with one that can."""
        trials = self.trials
        if not trials.made:
            assert trials.refusal is not None
            return trials.refusal
        limits = trials.tolerance
        least = ALMOST * min((each.misses(limits) for *_, each in trials.bare), default=0.0)
        for variant, trial, boards in sorted(trials.bare, key=lambda each: each[1].panels):
            if boards.misses(limits) <= least and trials.does(trials.carefully(variant, trial)):
                return refuse_boards(trial.rows, trial.columns, limits, boards)
        allowed = [
            each for each in trials.made if trials.fits(each[1]) and each[1] not in trials.large
        ]
        variant, nearest = smallest_of(allowed or trials.made, lambda each: each[1].error)
        nearest = trials.carefully(variant, nearest)
        few = [each for each in allowed if each[1].panels <= MANY]
        offered = nearest.error
        if nearest.panels > MANY and few:
            variant, quick = smallest_of(few, lambda each: each[1].error)
            offered = trials.carefully(variant, quick).error
        return refuse_distance(
            nearest,
            limits,
            "comes",
            f"{trials.sizes.most} rows and columns",
            NEARER * offered if allowed else None,
        )


def _first_between(low: int, high: int, holds: Callable[[int], bool]) -> int:
    """The first number for which a condition holds, if it holds from there to ``high``."""
    while low < high:
        middle = (low + high) // 2
        low, high = (low, middle) if holds(middle) else (middle + 1, high)
    return high


def _odd(number: float) -> int:
    """The odd number nearest to a number."""
    return max(1, 2 * round((number - 1) / 2) + 1)
