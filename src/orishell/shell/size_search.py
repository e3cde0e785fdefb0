"""The fewest panels that meet a tolerance: rows, columns and what else the design leaves open."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from itertools import product, repeat

from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress, unwatched
from orishell.conventions.quantities import plain
from orishell.design import Design
from orishell.errors import DesignError, Remedy
from orishell.families.pattern import Tolerance
from orishell.shell.choice import Choice, Measured, Trial, unbeaten

MOST = 201
"""Rows and columns tried at most, unless said otherwise."""
GROWTH = 1.6
"""Factor from one size to the next in the first, coarse search."""
SPREAD = (0.25, 0.62, 1.6, 0.8, 1.25, 0.9, 1.1)
"""Numbers of rows beside the best so far, for each of which the fewest columns are sought."""
STALE = 3
"""Steps of the coarse search that come no nearer, after which it is given up."""
TRIALS, FURTHER = 60, 6
"""Designs after which the search is content with what it has, at first and when aimed anew."""
REFUSALS = 12
"""Refused designs in a row, after which long and short panels are given up."""
RETRIES = 4
"""Times that the search is aimed anew, where the careful measure differs from the quick one."""
NEARER, FARTHER, MANY = 1.1, 5.0, 5_000
"""Tolerances that may be met where one is not, relative to the smallest error found; the second
where that takes so many panels, so that trying it takes less than the search that failed."""
NEARLY = 1.5
"""Errors up to so many times the aim are worth trying unlike rows and columns for."""
CHOOSING = "choosing rows and columns"
NEAR = 0.95
"""A design whose error is this share of the tolerance is near enough to it."""


def choose(
    make: Callable[[int, int], Design],
    measure: Callable[[Design, bool], Measured],
    tolerance: Tolerance,
    progress: Progress = unwatched,
    *,
    most: int = MOST,
) -> Choice:
    """Find the fewest panels that meet a tolerance.

    Errors fall with the number of rows and of columns. A ladder of ever finer sheets finds one
    that is near enough; from there the rows are varied, each time with as few columns as suffice.

    Raises
    ------
    DesignError
        If no sheet meets the tolerance; says what can be met.
    """
    search = _Search(make, measure, tolerance, progress, most)
    return search.run()


def trial_of(
    make: Callable[[int, int], Design],
    measure: Callable[[Design, bool], Measured],
    size: tuple[int, int],
    *,
    careful: bool,
) -> Trial:
    """Design a shell of a size (rows and columns of inner vertices), and measure it.

    Raises
    ------
    DesignError
        If the family refuses that size.
    """
    rows, columns = size
    measured = measure(make(rows, columns), careful)
    panels = (rows + 1) * (columns - 1)
    return Trial(rows, columns, panels, measured.error, measured.shortest, measured.longest)


def size_ladder(most: int) -> tuple[list[int], list[int]]:
    """Rows and columns of ever finer sheets, up to ``most``."""
    sizes = [2.0 * GROWTH**k for k in range(1, 10)]
    sizes = [size for size in sizes if size < most] + [float(most)]
    return [_odd(size) for size in sizes], [round(size) for size in sizes]


class _Search:
    def __init__(
        self,
        make: Callable[[int, int], Design],
        measure: Callable[[Design, bool], Measured],
        tolerance: Tolerance,
        progress: Progress,
        most: int,
    ) -> None:
        self.make, self.measure, self.tolerance, self.progress = make, measure, tolerance, progress
        self.most, self.budget = most, 0
        self.aim = tolerance.surface
        self.trials: dict[tuple[int, int], Trial | None] = {}
        self.refusal: DesignError | None = None

    def run(self) -> Choice:
        """Search, measure the result carefully, and search again if its error differs."""
        limit = self.tolerance.surface
        kept: Trial | None = None
        for attempt in range(RETRIES):
            self.budget = len(self.trials) + (FURTHER if attempt else TRIALS)
            try:
                best = self._improved(self._first())
            except DesignError:
                if kept is None:
                    raise
                break  # what was found before does
            careful = self._trial_of(best.rows, best.columns, True)
            if careful.error <= limit and (kept is None or careful.panels < kept.panels):
                kept = careful
            if kept is not None and (attempt or careful.error >= NEAR * limit):
                break
            self.aim = (NEAR if careful.error > limit else 1) * limit * best.error / careful.error
        if kept is None:
            raise self._refused()
        self.progress(1.0, CHOOSING)
        return Choice(
            kept,
            unbeaten(trial for trial in self.trials.values() if trial is not None),
            len(self.trials),
        )

    def _trial(self, rows: int, columns: int) -> Trial | None:
        """A quick measure of the design, made once; None if the family refuses it."""
        place = rows, columns
        if place not in self.trials:
            self.progress(min(0.95, len(self.trials) / 50), CHOOSING)
            try:
                self.trials[place] = self._trial_of(rows, columns, False)
            except DesignError as error:
                self.trials[place], self.refusal = None, error
        return self.trials[place]

    def _trial_of(self, rows: int, columns: int, careful: bool) -> Trial:
        return trial_of(self.make, self.measure, (rows, columns), careful=careful)

    def _fits(self, trial: Trial | None) -> bool:
        """Whether its panels have the sizes asked for."""
        limits = self.tolerance
        return trial is not None and trial.shortest >= limits.panel_min

    def _does(self, trial: Trial | None) -> bool:
        return (
            trial is not None
            and self._fits(trial)
            and trial.error <= self.aim
            and trial.longest <= self.tolerance.panel_max
        )

    def _first(self) -> Trial:
        """The first sheet that meets the aim: ever finer ones, then unlike rows and columns."""
        rows, columns = size_ladder(self.most)
        # Where g is straight more columns are of no use.
        for ladder in (zip(rows, repeat(2)), zip(rows, columns, strict=True)):
            found = self._climbed(ladder)
            if found is not None:
                return found
        # Rows and columns need not be alike: long panels may do where square ones are too small, or
        # where errors do not fall with both.
        small: list[tuple[int, int]] = []
        crossings = product(rows, columns) if self.tolerance.panel_min or self._near() else ()
        refused = 0
        for place in sorted(crossings, key=math.prod):
            if refused == REFUSALS or len(self.trials) > self.budget:
                break
            if any(place[0] >= r and place[1] >= c for r, c in small):
                continue
            trial = self._trial(*place)
            refused = refused + 1 if trial is None else 0
            if trial is not None and self._does(trial):
                return trial
            if trial is not None and not self._fits(trial):
                small.append(place)
        raise self._refused()

    def _near(self) -> bool:
        """Whether a sheet tried so far, with edges as long as they may be, nearly meets the aim."""
        return any(
            trial is not None
            and self._fits(trial)
            and trial.longest <= self.tolerance.panel_max
            and trial.error <= NEARLY * self.aim
            for trial in self.trials.values()
        )

    def _climbed(self, ladder: Iterable[tuple[int, int]]) -> Trial | None:
        """The first sheet of a ladder that meets the aim; None once finer ones come no nearer."""
        least, stale = math.inf, 0
        for rows, columns in ladder:
            trial = self._trial(rows, columns)
            if trial is None:
                continue
            if self._does(trial):
                return trial
            stale = 0 if trial.error < 0.9 * least else stale + 1
            least = min(least, trial.error)
            if stale == STALE or not self._fits(trial):
                break
        return None

    def _improved(self, best: Trial) -> Trial:
        """Vary the rows as long as that saves panels."""
        best = self._fewest_columns(best.rows, best) or best
        again = True
        while again:
            again = False
            for factor, step in (*((factor, 0) for factor in SPREAD), (1, -2), (1, 2)):
                if len(self.trials) > self.budget:
                    return best
                rows = _odd(best.rows * factor) + step
                better = self._fewest_columns(rows, best) if 1 <= rows <= self.most else None
                if better is not None:
                    best, again = better, True
        return best

    def _fewest_columns(self, rows: int, best: Trial) -> Trial | None:
        """The sheet with the fewest columns that meets the aim, if that saves panels."""
        high = min(self.most, (best.panels - 1) // (rows + 1) + 1)
        good = self._trial(rows, high) if high >= 2 else None
        if good is None or not self._does(good):
            return None
        low = max(1, high // 2)
        bad = self._trial(rows, low) if low > 1 else None
        while bad is not None and self._does(bad):
            good, high = bad, low
            low = max(1, low // 2)
            bad = self._trial(rows, low) if low > 1 else None
        while high - low > 1:
            middle = self._between(low, bad, high, good)
            trial = self._trial(rows, middle)
            if trial is not None and self._does(trial):
                good, high = trial, middle
            else:
                bad, low = trial, middle
        return good

    def _between(self, low: int, bad: Trial | None, high: int, good: Trial) -> int:
        """Columns at which the aim is met if errors fall as 1/n**2, between two numbers."""
        if bad is None or bad.error <= self.aim or bad.error <= good.error:
            return (low + high) // 2
        share = (self.aim - good.error) / (bad.error - good.error)
        inverse = (1 - share) / high**2 + share / low**2
        columns = math.ceil(1 / math.sqrt(inverse))
        return min(max(columns, low + 1), high - 1)

    def _refused(self) -> DesignError:
        """The error for a tolerance that cannot be met, with one that can."""
        fitting = [trial for trial in self.trials.values() if trial is not None]
        if not fitting:
            assert self.refusal is not None
            return self.refusal
        limits = self.tolerance
        allowed = [t for t in fitting if self._fits(t) and t.longest <= limits.panel_max]
        nearest = min(allowed or fitting, key=lambda trial: trial.error)
        nearest = self._trial_of(nearest.rows, nearest.columns, True)
        free = limits.panel_min == 0 and limits.panel_max == math.inf
        edges = (
            "" if free else f"panel edges from {limits.panel_min:g} to {limits.panel_max:g} and "
        )
        share = NEARER if nearest.panels < MANY else FARTHER
        return DesignError(
            f"no shell of this family comes within {limits.surface:g} of the surface",
            place=f"with {edges}at most {self.most} rows and columns",
            size=f"the nearest found, {nearest.rows} x {nearest.columns}, is "
            f"{plain(nearest.error)} "
            f"away, with edges from {plain(nearest.shortest)} to {plain(nearest.longest)}",
            candidates=[Remedy({"tolerance.surface": rounded(share * nearest.error)})]
            if allowed
            else (),
            excess=max(
                nearest.error / limits.surface,
                limits.panel_min / nearest.shortest,
                nearest.longest / limits.panel_max,
            )
            - 1,
        )


def _odd(number: float) -> int:
    """The odd number nearest to a number."""
    return max(1, 2 * round((number - 1) / 2) + 1)
