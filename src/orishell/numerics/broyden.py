"""Positive unknowns with which as many positive sizes are what is asked for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from orishell.numerics.arrays import Array

LARGEST_STEP = np.log(1.6)
"""Most that the logarithm of an unknown changes in one step."""
HALVINGS = 5
"""So often a step is halved that comes no nearer."""
DIFFERENCE = 0.01
"""Change of an unknown's logarithm from which derivatives are found."""
MOST_TRIALS = 30
"""Trials, at most."""

Measure = Callable[[Array], Array | None]
"""The sizes (k,) that unknowns (k,) give, all positive; None if they give nothing."""


@dataclass(slots=True)
class Sizing:
    """A search for unknowns by Broyden's method in logarithms.

    It begins with each size in proportion to its own unknown. (C. G. Broyden, A class of methods
    for solving nonlinear simultaneous equations, Math. Comp. 19, 1965.)
    """

    measure: Measure
    asked: Array  # sizes (k,)
    near: float  # by so much sizes may be off
    trials: int = 0
    # the unknowns that come nearest, and their sizes
    best: tuple[Array, Array] | None = field(default=None, init=False)

    @property
    def found(self) -> tuple[Array, Array]:
        """The unknowns that come nearest, and their sizes."""
        assert self.best is not None
        return self.best

    def run(self, start: Array) -> bool:
        """Whether unknowns are found, from those on which give something (k,)."""
        now, off = np.log(start), self._off(np.log(start))
        assert off is not None
        slopes, fresh = np.eye(len(now)), False
        while not self._done() and self.trials < MOST_TRIALS:
            step = -np.linalg.lstsq(slopes, off, rcond=1e-9)[0]
            step = step * min(1.0, LARGEST_STEP / max(float(np.abs(step).max()), 1e-300))
            found = self._shortened(now, off, step)
            if found is None and fresh:
                break
            if found is None:
                slopes, fresh = self._slopes(now, off), True
                continue
            share, nearer = found
            moved = share * step
            slopes = slopes + np.outer(nearer - off - slopes @ moved, moved) / (moved @ moved)
            now, off, fresh = now + moved, nearer, False
        return self._done()

    def _shortened(self, now: Array, off: Array, step: Array) -> tuple[float, Array] | None:
        """The share of a step that comes nearer, and how far off one is there."""
        for halving in range(HALVINGS):
            if self.trials >= MOST_TRIALS:
                return None
            share = 0.5**halving
            nearer = self._off(now + share * step)
            if nearer is not None and np.abs(nearer).max() < np.abs(off).max():
                return share, nearer
        return None

    def _slopes(self, now: Array, off: Array) -> Array:
        """Derivatives (k, k) by differences; of what gives nothing, as at the beginning."""
        slopes = np.eye(len(now))
        for k in range(len(now)):
            beside = self._off(now + DIFFERENCE * np.eye(len(now))[k])
            if beside is not None:
                slopes[:, k] = (beside - off) / DIFFERENCE
        return slopes

    def _off(self, logarithms: Array) -> Array | None:
        """By which factors sizes are off (logarithms)."""
        self.trials += 1
        unknowns = np.exp(logarithms)
        found = self.measure(unknowns)
        if found is None:
            return None
        if self.best is None or self._largest(found) < self._largest(self.best[1]):
            self.best = unknowns, found
        return np.log(found / self.asked)

    def _largest(self, found: Array) -> float:
        return float(np.abs(found - self.asked).max())

    def _done(self) -> bool:
        return self.best is not None and self._largest(self.best[1]) <= self.near
