"""A fit: curvature is turned on little by little, from the mean plane of a piece to the piece.

The steps are those of Levenberg and Marquardt, on residuals that are only there where conditions
hold (K. Levenberg, Quart. Appl. Math. 2 (1944) 164; D. W. Marquardt, SIAM J. Appl. Math. 11 (1963)
431).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.record import record
from orishell.design.piece import Piece
from orishell.families.flat_foldable.fit.conditions import Conditions
from orishell.families.flat_foldable.fit.figures import Reached, measure
from orishell.families.flat_foldable.fit.residuals import Fitted, Problem, Weights
from orishell.families.flat_foldable.fit.unknowns import OFFSET, Unknowns
from orishell.numerics.arrays import Array

FIRST_DAMPING, LEAST_DAMPING = 1e-3, 1e-9
"""Damping at first, and at least."""
TRIALS = 12
"""Steps of one direction that are tried, each more damped than the one before."""
FARTHEST = 0.5
"""No unknown changes by more than this in a step."""
STAGES_SHARE = 0.6
"""Of the work, that it is to turn the curvature on."""


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
    # Starts whose errors are so many times the least are given up once so much is turned on.
    lost: float = np.inf
    lost_from: float = 0.4
    weights: Weights = Weights()
    final: Weights = Weights(near=0.015, even=2e-3, smooth=1e-3, centre=0.1)  # distances count


THOROUGH = Course(12, 6, 1e-2, 40, 1e-3)
"""Of 6, 12 and 20 stages, 12 is the fewest with which sheets that bend much were not lost on the
way: they get into a corner of the conditions, and stick."""
FAST = Course(10, 3, 2e-2, 10, 1e-2, lost=5.0)
"""For sheets that are compared only.

In 20 fits to 10 surfaces the start that was nearest at the end had at most 1.5 times the least
error from 0.4 of the curvature on; those above 5 times ended 1.3 to 10 times as far away.
"""
NEARBY = Course(0, 0, 0.0, 60, 1e-5)
"""For sheets that begin with one of a surface nearby: so far that sizes change as the surface does,
where those of THOROUGH leap by millimetres in metres."""
MIRRORED = 1e-6
"""Starts whose errors differ by less than this share are alike by symmetry: over symmetric surfaces
they differed by 2e-7 after the first stage, others by more than 1e-4."""
WHAT = "fitting the sheet"


@record
class Begun:
    """A sheet that a fit begins with."""

    turns: int  # of the piece, as the sheet sees it
    of: Unknowns

    def problem(self, piece: Piece, weights: Weights, conditions: Conditions) -> Problem:
        """What is to be made small over a piece that is not turned yet."""
        return Problem(piece.turned(self.turns), self.of, weights, conditions)


def follow(
    piece: Piece,
    begun: Sequence[Begun],
    conditions: Conditions,
    course: Course = THOROUGH,
    progress: Progress = no_progress,
) -> list[tuple[Fitted, Reached] | None]:
    """The sheets that follow a piece from each start, or as far as it does; None where none starts.

    All starts are followed side by side, as what is known of a flattened piece serves them all.
    What a course gives up is None, as is a start that another one mirrors.
    """
    running = dict(enumerate(each.of.first for each in begun))
    shares = np.linspace(0, 1, course.stages + 1)[1:]
    for number, share in enumerate(shares):
        flat = piece.flattened(float(share))
        found: dict[int, Fitted] = {}
        for k, unknowns in running.items():
            problem = begun[k].problem(flat, course.weights, conditions)
            start = problem.at(unknowns)
            if start is not None:
                found[k] = descend(problem, start, course.steps, course.gain)
            done = (number + len(found) / len(running)) / len(shares)
            progress(STAGES_SHARE * done, WHAT)
        hopeful = _hopeful({k: each.error for k, each in found.items()}, course, float(share))
        running = {k: found[k].unknowns for k in hopeful}
    reached: list[tuple[Fitted, Reached] | None] = [None] * len(begun)
    for k, unknowns in running.items():
        reached[k] = settle(piece, begun[k], conditions, unknowns, course)
    return reached


def settle(
    piece: Piece, begun: Begun, conditions: Conditions, unknowns: Array, course: Course = NEARBY
) -> tuple[Fitted, Reached] | None:
    """The best sheet that unknowns (P,) near it lead to; None where they have none."""
    problem = begun.problem(piece, course.final, conditions)
    start = problem.at(unknowns)
    if start is None:
        return None
    found = descend(problem, start, course.last_steps, course.last_gain)
    return found, measure(problem.piece, found, begun.of.size, float(found.unknowns[OFFSET]))


def _hopeful(errors: Mapping[int, float], course: Course, share: float) -> list[int]:
    """Numbers of the starts that are followed further."""
    limit = course.lost * min(errors.values(), default=0.0) if share >= course.lost_from else np.inf
    kept: list[int] = []
    for k, error in errors.items():
        mirrors = any(abs(error - errors[other]) <= MIRRORED * error for other in kept)
        if error <= limit and not mirrors:
            kept.append(k)
    return kept
