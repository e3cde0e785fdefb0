"""Levenberg-Marquardt on residuals that are only there where conditions hold.

K. Levenberg, Quart. Appl. Math. 2 (1944) 164; D. W. Marquardt, SIAM J. Appl. Math. 11 (1963) 431.
"""

from __future__ import annotations

import numpy as np

from orishell.families.flat_foldable.fit.residuals import Fitted, Problem

FIRST_DAMPING, LEAST_DAMPING = 1e-3, 1e-9
"""Damping at first, and at least."""
TRIALS = 12
"""Steps of one direction that are tried, each more damped than the one before."""
FARTHEST = 0.5
"""No unknown changes by more than this in a step."""


def descend(problem: Problem, start: Fitted, steps: int, gain: float) -> Fitted:
    """The best found in so many steps, or fewer if one gains less than a share of the error."""
    best, damping = start, FIRST_DAMPING
    for _ in range(steps):
        hessian, gradient = _normal(problem, best)
        scale = np.diag(hessian)
        scale = scale + 0.02 * scale.mean()
        for _ in range(TRIALS):
            step = -np.linalg.solve(hessian + damping * np.diag(scale), gradient)
            step *= min(1.0, FARTHEST / np.abs(step).max())
            found = problem.at(best.unknowns + step)
            if found is not None and found.error < best.error:
                break
            damping = 4 * max(damping, LEAST_DAMPING)
        else:
            return best
        gained = 1 - found.error / best.error
        best, damping = found, max(damping / 5, LEAST_DAMPING)
        if gained < gain:
            break
    return best


def _normal(problem: Problem, at: Fitted) -> tuple[np.ndarray, np.ndarray]:
    """J^T J (P, P) and J^T r (P,)."""
    count = len(at.unknowns)
    hessian, gradient = np.zeros((count, count)), np.zeros(count)
    for residual, derivative in zip(at.residuals, problem.derivatives(at), strict=True):
        hessian += derivative.T @ derivative
        gradient += derivative.T @ residual
    return hessian, gradient
