"""A fit: curvature is turned on little by little, from the mean plane of a piece to the piece.

The steps are those of Levenberg and Marquardt, on residuals that are only there where conditions
hold (K. Levenberg, Quart. Appl. Math. 2 (1944) 164; D. W. Marquardt, SIAM J. Appl. Math. 11 (1963)
431).
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.record import record
from orishell.design.piece import Piece
from orishell.families.flat_foldable.fit.conditions import Conditions
from orishell.families.flat_foldable.fit.figures import Reached, measure
from orishell.families.flat_foldable.fit.residuals import Fitted, Problem, Weights
from orishell.families.flat_foldable.fit.unknowns import OFFSET, Unknowns

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


@record
class Course:
    """How much work is done."""

    stages: int  # shares of the curvature that are turned on, one after the other
    steps: int  # of a stage, at most
    gain: float  # share of the error that a step must gain
    last_steps: int  # the same at the end
    last_gain: float
    weights: Weights = Weights()
    final: Weights = Weights(near=0.015, even=2e-3, smooth=1e-3, centre=0.1)  # distances count


THOROUGH = Course(12, 6, 1e-2, 40, 1e-3)
"""Of 6, 12 and 20 stages, 12 is the fewest with which sheets that bend much were not lost on the
way: they get into a corner of the conditions, and stick."""
FAST = Course(10, 3, 2e-2, 10, 1e-2)
"""For sheets that are compared only."""


def follow(
    piece: Piece,
    of: Unknowns,
    conditions: Conditions,
    course: Course = THOROUGH,
    progress: Progress = no_progress,
) -> tuple[Fitted, Reached] | None:
    """The sheet that follows a piece from a start, or as far as it does; None where none starts."""
    unknowns = of.first
    for share in np.linspace(0, 1, course.stages + 1)[1:]:
        problem = Problem(piece.flattened(float(share)), of, course.weights, conditions)
        start = problem.at(unknowns)
        if start is None:
            return None
        unknowns = descend(problem, start, course.steps, course.gain).unknowns
        progress(0.6 * float(share), "fitting the sheet")
    problem = Problem(piece, of, course.final, conditions)
    start = problem.at(unknowns)
    if start is None:
        return None
    found = descend(problem, start, course.last_steps, course.last_gain)
    return found, measure(piece, found, of.size, float(found.unknowns[OFFSET]))
