"""Least squares by Levenberg and Marquardt, within what there is."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from orishell.families.flat_foldable.fit.residuals import Problem, State

LARGEST_STEP = 0.5
"""Of any unknown."""
TRIES = 12
"""Dampings that are tried for one step."""
FLOOR = 0.02
"""Damping of unknowns that matter little, as a share of the mean."""


def fitted(
    problem: Problem, start: State, steps: int, gain: float, told: Callable[[], None]
) -> State:
    """The sheet with the least sum of squares that so many steps find.

    gain: Steps end where one lowers the sum by a smaller share.
    """
    now, damping = start, 1e-3
    for _ in range(steps):
        told()
        derived = problem.state(now.unknowns, derived=True)
        assert derived is not None
        assert derived.derivatives is not None
        slope = derived.derivatives
        normal, downhill = slope.T @ slope, slope.T @ derived.residuals
        scale = np.diag(normal) + FLOOR * np.diag(normal).mean()
        better = None
        for _ in range(TRIES):
            step = -np.linalg.solve(normal + damping * np.diag(scale), downhill)
            step *= min(1.0, LARGEST_STEP / np.abs(step).max())
            found = problem.state(now.unknowns + step)
            if found is not None and found.error < derived.error:
                better = found
                break
            damping = 4 * max(damping, 1e-9)
        if better is None:
            return now
        gained = 1 - better.error / derived.error
        now, damping = better, max(damping / 5, 1e-9)
        if gained < gain:
            return now
    return now
