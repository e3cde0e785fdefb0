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

from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress, unwatched
from orishell.conventions.quantities import plain
from orishell.errors import DesignError, Remedy
from orishell.families.pattern import Tolerance, Variants
from orishell.shell.choice import Choice, Measured, Trial, unbeaten

MOST = 201
"""Rows and columns tried at most, unless said otherwise."""
GROWTH = 1.6
"""Factor from one size to the next in the first, coarse search."""
STALE = 3
"""Steps of the coarse search that come no nearer, after which it is given up."""
NEARLY = 1.5
"""Sheets off by so much are worth trying unlike rows and columns for."""
FEW = 40
"""Where none is found, all sizes of up to so many panels are tried."""
REFUSALS, CROSSED = 12, 60
"""Refused designs in a row, and designs in all, after which long and short panels are given up."""
LEAST = 0.95
"""A shell is at such a share of the distance from its surface at least that column 1 has from f, or
the middle row from g: of 1,100 random shells of three families none was nearer than 0.98 of it."""
NEAR = 1.15
"""Sizes off by such a factor with the variants that are telling leave no hope for others,"""
ALIKE, SAME = 1.01, 3
"""nor do so many variants that are off by the same factor, or nearly: they make no difference."""
CALM = 10
"""From so many columns on errors rise and fall the less with their number, the more there are."""
NEARER, FARTHER, MANY = 1.1, 5.0, 5_000
"""Tolerances that may be met where one is not, relative to the smallest error found; the second
where that takes so many panels, so that trying it takes less than the search that failed."""
CHOOSING = "choosing rows and columns"
USUAL = 60
"""Designs that a search tries, about: for its progress."""

V = TypeVar("V")


@dataclass(frozen=True, slots=True, eq=False)
class Sizes(Generic[V]):
    """The sheets that a tolerance is to be met with: variants with numbers of rows and columns.

    Parameters
    ----------
    variants
        The variants for a number of rows.
    distance_from_f
        A distance at which column 1 of a variant is from f at least.
    distance_from_g
        A distance at which the middle row of so many columns is from g at least.
    measure
        Makes a variant with so many columns, and measures it, carefully or quickly.
    oversize
        How much larger than the boards the largest panel of it is: 1 or less if all fit.
    most, step
        The largest number of rows and of columns; the step from one number of rows to the next.
    ripple, orderly
        By which factor a shell may be farther from its surface than one with fewer columns; whether
        that holds for rows as well, and no shell is nearer whose column 1 is farther from f.
    """

    variants: Callable[[int], Variants[V]]
    distance_from_f: Callable[[V], float]
    distance_from_g: Callable[[int], float]
    measure: Callable[[V, int, bool], Measured]
    oversize: Callable[[V, int], float] = lambda _variant, _columns: 0.0
    most: int = MOST
    step: int = 2
    ripple: float = 1.15
    orderly: bool = True


def choose(
    sizes: Sizes[V], tolerance: Tolerance, progress: Progress = unwatched
) -> tuple[V, Choice]:
    """Find the variant and the size with the fewest panels that meet a tolerance.

    Raises
    ------
    DesignError
        If no sheet meets the tolerance; says what can be met.
    """
    return _Search(sizes, tolerance, progress).run()


def trial_of(size: tuple[int, int], measured: Measured) -> Trial:
    """What was measured of a sheet of a size (rows and columns of inner vertices)."""
    rows, columns = size
    panels = (rows + 1) * (columns - 1)
    return Trial(rows, columns, panels, measured.error, measured.shortest, measured.longest)


def size_ladder(most: int) -> tuple[list[int], list[int]]:
    """Rows and columns of ever finer sheets, up to ``most``."""
    sizes = [2.0 * GROWTH**k for k in range(1, 10)]
    sizes = [size for size in sizes if size < most] + [float(most)]
    return [_odd(size) for size in sizes], [round(size) for size in sizes]


@dataclass(frozen=True, slots=True)
class _Tried(Generic[V]):
    """What was found out of a size: how far it is off with its best variant, as factors.

    ``off`` is that of its distance from the surface and of edges or panels that are too long,
    which more columns may mend, infinite where all variants are refused; ``small`` that of edges
    that are too short. ``variant`` is one that does.
    """

    off: float
    small: float
    variant: V | None = None


@dataclass(slots=True, eq=False)
class _Search(Generic[V]):
    sizes: Sizes[V]
    tolerance: Tolerance
    progress: Progress
    tried: list[tuple[V, Trial]] = field(default_factory=list)
    large: list[Trial] = field(default_factory=list)
    bounded: bool = True
    careful: bool = False
    least: float = math.inf
    known: dict[tuple[int, int], _Tried[V]] = field(default_factory=dict)
    reached: dict[int, bool] = field(default_factory=dict)
    refusal: DesignError | None = None
    found: list[tuple[V, Trial]] = field(default_factory=list)

    def run(self) -> tuple[V, Choice]:
        """Find any sheet that does, then all with fewer panels that may."""
        while True:
            self._look()
            if self._all_too_long():
                raise self._refused()
            if not self.found and not any(self._fits(each) for _, each in self.tried):
                self.bounded = False  # f or g rule out all that fit: how near do these come?
                self._look()
                self.bounded = not self.found
            for rows in self._rows():
                self._fewest_columns(rows)
            if not self.found:
                raise self._refused()
            variant, quick = min(self.found, key=lambda each: each[1].panels)
            trial = self._carefully(variant, quick)
            if self._does(trial):
                break
            self.found.remove((variant, quick))
            self.known.pop((quick.rows, quick.columns), None)
            self.careful = True
        self.progress(1.0, CHOOSING)
        tried = [trial if each is quick else each for _, each in self.tried if self._fits(each)]
        return variant, Choice(trial, unbeaten(tried), len(self.tried))

    @property
    def below(self) -> int:
        """Sheets with fewer panels than this are looked for."""
        return min((trial.panels for _, trial in self.found), default=FEW + 1)

    def _look(self) -> None:
        """Look for any sheet that does, along ladders of ever finer ones first."""
        rows, columns = size_ladder(self.sizes.most)
        # Where g is straight more columns are of no use.
        for ladder in (zip(rows, repeat(2)), zip(rows, columns, strict=True)):
            if not self.found:
                self._climb(ladder)
        if not self.found and (self.tolerance.panel_min or self.least <= NEARLY):
            self._cross()

    def _climb(self, ladder: Iterable[tuple[int, int]]) -> None:
        """Try the sheets of a ladder until one does, or finer ones come no nearer."""
        least, stale = math.inf, 0
        for rows, columns in ladder:
            if self.bounded and not self._within_reach(columns):
                continue
            tried = self._try(rows, columns, widely=False)
            if tried.variant is not None:
                return
            stale = 0 if tried.off < 0.9 * least else stale + 1
            least = min(least, tried.off)
            self.least = min(self.least, least)
            if math.isfinite(least) and (stale == STALE or tried.small > 1):
                return

    def _cross(self) -> None:
        """Unlike rows and columns: long panels may do where square ones are too small."""
        rows, columns = size_ladder(self.sizes.most)
        small: list[tuple[int, int]] = []
        refused = 0
        for place in sorted(product([1, *rows], columns), key=math.prod):
            if self.found or refused == REFUSALS or len(self.tried) > CROSSED:
                return
            if any(place[0] >= m and place[1] >= n for m, n in small):
                continue
            if not self.bounded or self._within_reach(place[1]):
                tried = self._try(*place, widely=False)
                refused = refused + 1 if tried.off == math.inf else 0
                if tried.small > 1:
                    small.append(place)

    def _all_too_long(self) -> bool:
        """Whether edges are too long in all sheets: sheets with few panels have longer ones."""
        longest = self.tolerance.panel_max
        return bool(self.tried) and all(each.longest > longest for _, each in self.tried)

    def _rows(self) -> Iterator[int]:
        """Numbers of rows for which there may be fewer panels, those of the best one first."""
        fewest = self._fewest_of_all()
        left = set(range(1, min(self.sizes.most, self.below) + 1, self.sizes.step))
        while left:
            best = min(self.found, key=lambda each: each[1].panels)[1].rows if self.found else 0
            rows = min(left, key=lambda rows: (abs(math.log((rows + 1) / (best + 1))), rows))
            left.remove(rows)
            if (rows + 1) * (fewest - 1) < self.below:
                yield rows

    def _within_reach(self, columns: int) -> bool:
        """Whether g allows so few columns."""
        if columns not in self.reached:
            try:
                least = LEAST * self.sizes.distance_from_g(columns)
                self.reached[columns] = least <= self.tolerance.surface
            except DesignError as error:
                self.refusal, self.reached[columns] = self.refusal or error, False
        return self.reached[columns]

    def _fewest_of_all(self) -> int:
        """The fewest columns that g allows."""
        high = 2
        while high < self.sizes.most and not self._within_reach(high):
            high = min(2 * high, self.sizes.most)
        return _first_between(high // 2, high, self._within_reach) if high > 2 else 2

    def _fewest_columns(self, rows: int) -> None:
        """Find the fewest columns of so many rows that do, if that saves panels."""
        fewest = self._fewest_of_all()
        most = min((self.below - 1) // (rows + 1) + 1, self.sizes.most)
        if most < fewest or self._tried(rows, fewest).variant is not None:
            return
        if self._leaves_no_hope(most, self._tried(rows, most).off):
            return

        def near(columns: int) -> bool:
            return self._tried(rows, columns).off <= self._ripple(columns)

        for columns in range(_first_between(fewest, most, near), most):
            tried = self._tried(rows, columns)
            if tried.variant is not None or (tried.off < 1 / NEAR and tried.small > NEAR):
                return

    def _tried(self, rows: int, columns: int) -> _Tried[V]:
        """What was found out of a size, with all variants that may do."""
        place = rows, columns
        if place not in self.known:
            self.known[place] = self._ruled_out(*place) or self._try(*place, widely=True)
        return self.known[place]

    def _ruled_out(self, rows: int, columns: int) -> _Tried[V] | None:
        """What was found out of a finer sheet, if that is too far off for this one to do."""
        for (more, others), tried in self.known.items():
            finer = others >= columns and (more == rows or (self.sizes.orderly and more >= rows))
            if finer and self._leaves_no_hope(others, tried.off):
                return tried
        return None

    def _leaves_no_hope(self, columns: int, off: float) -> bool:
        """Whether a sheet is too far off for one with fewer columns to do."""
        return self._ripple(columns) < off < math.inf

    def _ripple(self, columns: int) -> float:
        """By which factor sheets with fewer columns may be nearer: by less if these are many."""
        return 1 + (self.sizes.ripple - 1) * min(1.0, CALM / columns)

    def _try(self, rows: int, columns: int, widely: bool) -> _Tried[V]:
        off = small = too_far = math.inf
        excesses: list[float] = []
        try:
            variants = self.sizes.variants(rows)
        except DesignError as error:
            self.refusal = self.refusal or error
            return _Tried(off, small)
        for number, variant in enumerate((*variants.telling, *variants.others)):
            if number >= len(variants.telling) and not (widely and _worth_more(excesses)):
                break
            try:
                least = LEAST * self.sizes.distance_from_f(variant) / self.tolerance.surface
                if self.bounded and least > 1:
                    off = min(off, least)
                    excesses.append(least)
                    continue
                if self.sizes.orderly and least > too_far:
                    continue
                trial = self._measured(variant, rows, columns)
                size = self.sizes.oversize(variant, columns) if self._does(trial) else 0.0
                if size > 1:
                    self.large.append(trial)
            except DesignError as error:
                self.refusal = self.refusal or error
                continue
            limits = self.tolerance
            excess = max(trial.error / limits.surface, trial.longest / limits.panel_max, size)
            if max(excess, limits.panel_min / trial.shortest) <= 1:
                self.found.append((variant, trial))
                return _Tried(1.0, 1.0, variant)
            if trial.error > limits.surface:
                too_far = min(too_far, least)
            off, small = min(off, excess), min(small, limits.panel_min / trial.shortest)
            excesses.append(max(excess, limits.panel_min / trial.shortest))
        return _Tried(off, small if small < math.inf else 0.0)

    def _measured(self, variant: V, rows: int, columns: int) -> Trial:
        """A quick measure of a design, and a careful one if quick ones were too kind before."""
        self.progress(0.95 * (1 - math.exp(-len(self.tried) / USUAL)), CHOOSING)
        trial = trial_of((rows, columns), self.sizes.measure(variant, columns, False))
        if self.careful and self._does(trial):
            trial = self._carefully(variant, trial)
        self.tried.append((variant, trial))
        return trial

    def _carefully(self, variant: V, quick: Trial) -> Trial:
        careful = self.sizes.measure(variant, quick.columns, True)
        return trial_of((quick.rows, quick.columns), careful)

    def _does(self, trial: Trial) -> bool:
        return self._fits(trial) and trial.error <= self.tolerance.surface

    def _fits(self, trial: Trial) -> bool:
        """Whether its edges have the lengths asked for."""
        limits = self.tolerance
        return limits.panel_min <= trial.shortest and trial.longest <= limits.panel_max

    def _refused(self) -> DesignError:
        """The error for a tolerance that cannot be met, with one that can."""
        if not self.tried:
            assert self.refusal is not None
            return self.refusal
        limits = self.tolerance
        allowed = [each for each in self.tried if self._fits(each[1]) and each[1] not in self.large]
        variant, nearest = min(allowed or self.tried, key=lambda each: each[1].error)
        nearest = self._carefully(variant, nearest)
        edges = f"panel edges from {limits.panel_min:g} to {limits.panel_max:g} and "
        share = NEARER if nearest.panels < MANY else FARTHER
        return DesignError(
            f"no shell of this family comes within {limits.surface:g} of the surface",
            place=f"with {edges if limits.limits_edges else ''}at most {self.sizes.most} rows and "
            "columns",
            size=f"the nearest found, {nearest.rows} x {nearest.columns}, is "
            f"{plain(nearest.error)} away, with edges from {plain(nearest.shortest)} to "
            f"{plain(nearest.longest)}",
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


def _worth_more(excesses: list[float]) -> bool:
    """Whether others than the telling variants may do, which are off by such factors."""
    least = min(excesses, default=1.0)
    return least <= NEAR and sum(each <= ALIKE * least for each in excesses) < SAME


def _first_between(low: int, high: int, holds: Callable[[int], bool]) -> int:
    """The first number for which a condition holds, if it holds from there to ``high``."""
    while low < high:
        middle = (low + high) // 2
        low, high = (low, middle) if holds(middle) else (middle + 1, high)
    return high


def _odd(number: float) -> int:
    """The odd number nearest to a number."""
    return max(1, 2 * round((number - 1) / 2) + 1)
