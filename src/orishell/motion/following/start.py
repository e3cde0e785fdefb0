"""A first folded state, nearly flat: from there a motion is followed."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.motion.following.correcting import Linearised
from orishell.motion.following.system import Closure
from orishell.numerics.arrays import Array, Booleans

SIZE = 0.05
"""The largest fold angle of the first state (radians)."""
FIRST_FOLD = 1e-3
"""The largest fold angle of the state before (radians): orders beyond two hardly count there."""
MOUNTAINS = 0.8
"""At the first start mountains are folded by this share of valleys: no sheet is halfway then."""
SPREAD = 0.5
"""At further starts fold angles are of different sizes: the deviation of their logarithms."""
PUSHES = 10
"""So many starts in turn begin where the last one came to, creases that fold the wrong way turned
to where they should: by this share of the mean fold angle."""
PUSH = 0.5
TRIES = 40
"""Starts that are tried, at most."""
ENOUGH = 40_000
"""Creases of all starts together: of larger sheets fewer are tried."""
STEPS = 25
"""Steps of Gauss and Newton from each."""
LONGEST = 0.5
"""A step changes no fold angle by more than this share of the first state's."""
EXACT = 1e-13
"""A first state that misses by no more is closed but for rounding (radians)."""
UNFOLDED = 1e-6
"""A crease is unfolded if its fold angle is below this share of the largest."""


@record
class Start:
    """A state near the flat one, or the nearest to one that was found."""

    folds: Array  # fold angles (N,) of the unknowns (radians)
    residual: float  # by how much it misses closure (radians)
    unfolded: Booleans  # which creases (N,) do not fold
    against: Booleans  # which creases (N,) do not fold as their letter asks
    closed: bool  # whether it is a folded state at all
    tries: int = 1  # so many starts were tried

    @property
    def found(self) -> bool:
        """Whether it is a state with the signs that are asked for."""
        return self.closed and not self.against.any()


def find_start(closure: Closure, signs: Array, tolerance: float = 0.0) -> Start:
    """Look for a state near the flat one with the signs asked for, from several starts in turn.

    Near the flat state fold angles satisfy linear and quadratic equations, to first and second
    order; they are solved as they are, at a small size, by steps of Gauss and Newton that leave the
    sum of the fold angles, each with its sign, as it is. In the first start all are of one size;
    where signs are missing some are drawn, the same ones in every run. Of states that keep all
    signs the one with the fewest unfolded creases is taken.

    Parameters
    ----------
    signs
        Signs (N,) of the unknowns: +1 valley, -1 mountain, NaN where none is asked for.
    tolerance
        By how much folded states may miss closing: this nearly flat one by this times the square
        of its largest fold angle, as what is left grows with that (radians).
    """
    best: Start | None = None
    here: Start | None = None
    asked = ~np.isnan(signs)
    tries = int(np.clip(ENOUGH // max(len(signs), 1), 4, TRIES))
    for number in range(tries):
        if here is not None and here.closed and here.against.any() and number % PUSHES:
            pushed = signs * PUSH * np.abs(here.folds).mean()
            first = np.where(here.against, pushed, here.folds)
        else:
            rng = np.random.default_rng(number)
            first = np.where(asked, signs, rng.choice([-1.0, 1.0], len(signs)))
            first = first * np.where(first > 0, 1.0, MOUNTAINS)
            if number > 0:
                first = first * np.exp(rng.normal(0, SPREAD, len(signs)))
        folds, residual = _closed_near(closure, first)
        unfolded = np.abs(folds) <= UNFOLDED * SIZE
        against = asked & (unfolded | (np.sign(folds) != signs))
        closed = residual <= max(EXACT, tolerance * SIZE**2)
        here = Start(folds, residual, unfolded, against, closed)
        if best is None or _order(here) < _order(best):
            best = here
        exact = best.residual <= EXACT or asked.all()
        if exact and best.found and not best.unfolded.any():
            break
    assert best is not None
    return replace(best, tries=number + 1)


def _order(start: Start) -> tuple[bool, float]:
    """Closed states first, those with most signs kept; then those that miss least."""
    if start.closed:
        return False, float((start.against | start.unfolded).sum() + start.against.any())
    return True, start.residual


def _closed_near(closure: Closure, folds: Array) -> tuple[Array, float]:
    """A closed state reached from fold angles (N,), and by how much it misses."""
    if not len(folds):
        return folds, 0.0
    along = np.sign(folds)
    folds = Linearised(closure, np.zeros_like(folds)).motion(folds)
    for size in (FIRST_FOLD, SIZE):
        folds = size * folds / np.abs(folds).max()
        for _ in range(STEPS):
            here = Linearised(closure, folds)
            if here.residual <= EXACT:
                break
            change = here.correction(along)
            longest = max(np.abs(change).max() / (LONGEST * size), 1.0)
            folds = folds + change / longest
            folds = folds * size / np.abs(folds).max()
    return folds, here.residual
