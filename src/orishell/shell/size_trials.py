"""Designs that are tried to meet a tolerance, and the one that is chosen."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Generic, Self, TypeVar

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.design import Design
from orishell.deviation import SAMPLES as CAREFUL
from orishell.deviation import find_excess, measure_deviation
from orishell.families.tolerance import Tolerance, Variants
from orishell.motion.quads import lengths
from orishell.numerics.equals import NEAR as EQUAL
from orishell.shell.board_limits import NO_BOARDS, BoardFit


@dataclass(frozen=True, slots=True)
class Trial:
    """A design that was tried."""

    # inner vertices
    rows: int
    columns: int
    panels: int  # number of panels, flaps left out
    error: float  # distance between shell and target surface, largest both ways (length)
    # edges of its panels in the flat sheet (length)
    shortest: float
    longest: float

    @classmethod
    def of(cls, rows: int, columns: int, error: float, shortest: float, longest: float) -> Self:
        """A design with so many inner vertices."""
        return cls(rows, columns, (rows + 1) * (columns - 1), error, shortest, longest)


def refuse_distance(
    nearest: Trial, limits: Tolerance, said: str, sizes: str, offered: float | None
) -> DesignError:
    """The error where no sheet is near enough to its surface, of the nearest that was made.

    said, sizes: What is said of shells, and of the sizes that were tried.
    offered: What may be met (length); None to offer nothing.
    """
    edges = f"panel edges from {limits.panel_min:g} to {limits.panel_max:g} and "
    return DesignError(
        f"no shell of this family {said} within {limits.surface:g} of the surface",
        place=f"with {edges if limits.limits_edges else ''}at most {sizes}",
        size=f"the nearest found, {nearest.rows} x {nearest.columns}, is {plain(nearest.error)} "
        f"away, with edges from {plain(nearest.shortest)} to {plain(nearest.longest)}",
        candidates=() if offered is None else [Remedy({"tolerance.surface": rounded(offered)})],
        excess=max(
            nearest.error / limits.surface,
            limits.panel_min / nearest.shortest,
            nearest.longest / limits.panel_max,
        )
        - 1,
    )


QUICK = 1_000
"""Samples each way during the search; the result is measured with as many as for the report."""
NOTHING_ALLOWED = Tolerance.model_construct(surface=0.0)


def measure(design: Design, careful: bool, tolerance: Tolerance = NOTHING_ALLOWED) -> Trial:
    """Distance of a design from its surface, and the edges of its panels, flaps left out."""
    mechanism = design.mechanism
    flat = mechanism.positions(0.0)[:, mechanism.inner_columns]
    edges = [lengths(np.diff(flat, axis=axis)) for axis in (0, 1)]
    shortest = float(min(each.min() for each in edges))
    longest = float(max(each.max() for each in edges))
    if careful:
        error = measure_deviation(design, samples=CAREFUL).max
    else:
        fits = tolerance.allows(shortest, longest)
        error = find_excess(design, tolerance.surface if fits else 0.0, samples=QUICK)
    return Trial.of(len(flat) - 2, flat.shape[1], error, shortest, longest)


@record
class Choice:
    """The design with the fewest panels, and the others that were looked at."""

    REPORTED = (
        "tolerance", "limits.panel_min", "panel_max", "limits.least_share",
        "limits.steepest_chamfer_deg", "trial.rows", "trial.columns", "trial.panels",
        "trial.error", "trial.shortest", "trial.longest", "designs_tried", "tradeoff",
    )  # fmt: skip

    trial: Trial  # its sizes and its error, carefully measured
    # of all trials those that no other beats in both error and number of panels, by panels
    tradeoff: tuple[Trial, ...]
    designs_tried: int  # number of designs measured
    limits: Tolerance  # what was asked for

    @property
    def tolerance(self) -> float:
        """Distance from the surface that was asked for (length)."""
        return self.limits.surface

    @property
    def panel_max(self) -> float | None:
        """The longest edge that was asked for; None if edges may have any length."""
        return self.limits.panel_max if math.isfinite(self.limits.panel_max) else None


def unbeaten(trials: Iterable[Trial], gain: float = 1.0) -> tuple[Trial, ...]:
    """Trials that no other beats in both error and number of panels, by panels.

    The error of one with more panels must be below a share ``gain`` of that of the one before.
    """
    kept: list[Trial] = []
    for trial in sorted(trials, key=lambda each: (each.panels, rounded(each.error, 9))):
        if not kept or trial.error < gain * (1 - EQUAL) * kept[-1].error:
            kept.append(trial)
    return tuple(kept)


MOST_ROWS = 201
"""Rows and columns tried at most, unless said otherwise."""
SURELY_AWAY = 0.95
"""A shell is at such a share of the distance from its surface at least that column 1 has from f, or
the middle row from g: of 1,100 random shells of three families none was nearer than 0.98 of it."""
NEAR = 1.15
"""Sizes off by such a factor with the variants that are telling leave no hope for others,"""
ALIKE, SAME = 1.01, 3
"""nor do so many variants that are off by the same factor, or nearly: they make no difference."""
GIVEN_UP = 3
"""A variant that was refused at so many sizes, and never made, is not tried again."""
CHOOSING = "choosing rows and columns"
USUAL = 60
"""Designs that a search tries, about: for its progress."""

V = TypeVar("V")


@record
class Sizes(Generic[V]):
    """The sheets that a tolerance is to be met with: variants with numbers of rows and columns."""

    variants: Callable[[int], Variants[V]]  # for a number of rows
    distance_from_f: Callable[[V], float]  # of column 1, at least
    distance_from_g: Callable[[int], float]  # of the middle row of so many columns, at least
    measure: Callable[[V, int, bool], Trial]  # with so many columns, carefully or quickly
    # what its boards are like, of one that does in all else
    boards: Callable[[V, int], BoardFit] = lambda _variant, _columns: NO_BOARDS
    most: int = MOST_ROWS  # rows and columns
    step: int = 2  # from one number of rows to the next
    # by which factor a shell may be farther from its surface than one with fewer columns
    ripple: float = 1.15
    # whether that holds for rows as well, and none is nearer whose column 1 is farther from f
    orderly: bool = True


@dataclass(frozen=True, slots=True)
class Tried(Generic[V]):
    """What was found out of a size: how far it is off with its best variant, as factors."""

    # of its distance from the surface and of edges or panels that are too long, which more columns
    # may mend; infinite where all variants are refused
    off: float
    small: float  # of edges that are too short, and boards that cover too little
    variant: V | None = None  # one that does


@dataclass(slots=True, eq=False)
class Trials(Generic[V]):
    """Makes sheets of one size after another."""

    sizes: Sizes[V]
    tolerance: Tolerance
    progress: Progress
    made: list[tuple[V, Trial]] = field(default_factory=list)
    large: list[Trial] = field(default_factory=list)  # those whose parts do not fit the stock
    # those that do, but for the share or the chamfers of their boards
    bare: list[tuple[V, Trial, BoardFit]] = field(default_factory=list)
    found: list[tuple[V, Trial]] = field(default_factory=list)  # those that meet the tolerance
    refusal: DesignError | None = None  # the first
    bounded: bool = True  # whether sheets that f or g rule out are left out
    careful: bool = False  # whether those that do are measured carefully at once
    reached: dict[int, bool] = field(default_factory=dict)  # whether g allows so many columns
    # how often each variant was refused, by its place among all; those that were made
    refused: Counter[int] = field(default_factory=Counter)
    possible: set[int] = field(default_factory=set)

    def within_reach(self, columns: int) -> bool:
        """Whether g allows so few columns."""
        if columns not in self.reached:
            try:
                least = SURELY_AWAY * self.sizes.distance_from_g(columns)
                self.reached[columns] = least <= self.tolerance.surface
            except DesignError as error:
                self.refusal, self.reached[columns] = self.refusal or error, False
        return self.reached[columns]

    def make(self, rows: int, columns: int, widely: bool) -> Tried[V]:
        """Try the telling variants of a size until one does; all of them, if that is worth it."""
        off = small = too_far = math.inf
        excesses: list[float] = []
        try:
            variants = self.sizes.variants(rows)
        except DesignError as error:
            self.refusal = self.refusal or error
            return Tried(off, small)
        for number, variant in enumerate((*variants.telling, *variants.others)):
            if number >= len(variants.telling):
                if not (widely and _worth_more(excesses)):
                    break
                if self.refused[number] >= GIVEN_UP and number not in self.possible:
                    continue
            try:
                least = SURELY_AWAY * self.sizes.distance_from_f(variant) / self.tolerance.surface
                if self.bounded and least > 1:
                    off = min(off, least)
                    excesses.append(least)
                    continue
                if self.sizes.orderly and least > too_far:
                    continue
                trial = self._measured(variant, columns)
                does = self.does(trial)
                boards = self.sizes.boards(variant, columns) if does else NO_BOARDS
            except DesignError as error:
                self.refusal = self.refusal or error
                self.refused[number] += 1
                continue
            self.possible.add(number)
            limits, oversize = self.tolerance, boards.oversize
            excess = max(trial.error / limits.surface, trial.longest / limits.panel_max, oversize)
            short = max(limits.panel_min / trial.shortest, boards.bare(limits))
            worst = max(excess, short, boards.steep(limits))
            if worst <= 1:
                self.found.append((variant, trial))
                return Tried(1.0, 1.0, variant)
            if oversize > 1:
                self.large.append(trial)
            elif does:
                self.bare.append((variant, trial, boards))
            if trial.error > limits.surface:
                too_far = min(too_far, least)
            off, small = min(off, excess), min(small, short)
            excesses.append(worst)
        return Tried(off, small if small < math.inf else 0.0)

    def carefully(self, variant: V, quick: Trial) -> Trial:
        """The trial of that sheet with its error as the report has it."""
        return self.sizes.measure(variant, quick.columns, True)

    def does(self, trial: Trial) -> bool:
        """Whether it meets the tolerance, stock and boards aside."""
        return self.fits(trial) and trial.error <= self.tolerance.surface

    def fits(self, trial: Trial) -> bool:
        """Whether its edges have the lengths asked for."""
        return self.tolerance.allows(trial.shortest, trial.longest)

    def fitting(self) -> list[Trial]:
        """Trials of which nothing is known but their distance that speaks against them."""
        barred = [*self.large, *(trial for _, trial, _ in self.bare)]
        return [each for _, each in self.made if self.fits(each) and each not in barred]

    def _measured(self, variant: V, columns: int) -> Trial:
        """A quick measure of a design, and a careful one if quick ones were too kind before."""
        self.progress(0.95 * (1 - math.exp(-len(self.made) / USUAL)), CHOOSING)
        trial = self.sizes.measure(variant, columns, False)
        if self.careful and self.does(trial):
            trial = self.carefully(variant, trial)
        self.made.append((variant, trial))
        return trial


def _worth_more(excesses: list[float]) -> bool:
    """Whether others than the telling variants may do, which are off by such factors."""
    least = min(excesses, default=1.0)
    return least <= NEAR and sum(each <= ALIKE * least for each in excesses) < SAME
