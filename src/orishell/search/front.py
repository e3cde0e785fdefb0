"""The front of a search: designs that no other beats, their order, and the knee among them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.search.evaluate import Outcome
from orishell.search.feasible import violation
from orishell.search.problem import Problem
from orishell.search.space import key_of

NEXT_TO_NOTHING = 5e-4
"""Changes below this share are not worth a word."""


@record
class Front:
    """Designs that no other beats in all objectives at once.

    Parameters
    ----------
    members
        The designs, by their first objective, those equal in it by the next.
    knee
        Which of them is farthest below the plane through the ends of the front, objectives
        measured by their ranges: to either side a little less of one costs much of another. An end,
        where none is below it.
    """

    members: tuple[Outcome, ...]
    knee: int

    def name(self, number: int) -> str:
        """What a member is called: all names are equally long, so that they sort.

        Parameters
        ----------
        number
            Its place in the front, from 0.
        """
        width = max(2, len(str(len(self.members))))
        return f"front-{number + 1:0{width}}"


def front_of(problem: Problem, outcomes: Sequence[Outcome]) -> Front | None:
    """The front of designs that were made; None if none keeps all limits.

    Parameters
    ----------
    problem
        Objectives and limits.
    outcomes
        The designs.
    """
    feasible = [each for each in outcomes if violation(problem, each) == 0.0]
    if not feasible:
        return None
    ordered = sorted(feasible, key=lambda each: (*scores(problem, each), key_of(each.values)))
    kept = [ordered[k] for k in unbeaten(np.array([scores(problem, each) for each in ordered]))]
    return Front(tuple(kept), _knee(np.array([scores(problem, each) for each in kept])))


def beaten(problem: Problem, outcomes: Sequence[Outcome], front: Front) -> list[Outcome]:
    """The designs that keep all limits and are not on the front.

    Parameters
    ----------
    problem
        The limits.
    outcomes
        The designs.
    front
        The front.
    """
    kept = {key_of(each.values) for each in front.members}
    return [
        each
        for each in outcomes
        if key_of(each.values) not in kept and violation(problem, each) == 0.0
    ]


def scores(problem: Problem, outcome: Outcome) -> tuple[float, ...]:
    """The objectives of a design that was made."""
    return tuple(outcome.figures[each.name] for each in problem.objectives)


def unbeaten(points: Array) -> list[int]:
    """Which points no other is at least as good as; of equal ones the first.

    Parameters
    ----------
    points
        Objectives, (count, objectives), in lexicographic order: none is beaten by a later one.
    """
    kept: list[int] = []
    for k, point in enumerate(points):
        if not (points[kept] <= point).all(axis=1).any():
            kept.append(k)
    return kept


def _knee(points: Array) -> int:
    """Least sum of objectives, each scaled to its range: the plane's normal is (1, ..., 1)."""
    low, high = points.min(axis=0), points.max(axis=0)
    return int(((points - low) / np.where(high > low, high - low, 1.0)).sum(axis=1).argmin())


def costs(problem: Problem, before: Outcome, after: Outcome) -> str:
    """What a step from one design to another gains, then what it costs, in words.

    Parameters
    ----------
    problem
        The objectives.
    before, after
        The designs.
    """
    gained: list[str] = []
    paid: list[str] = []
    for each in problem.objectives:
        was, becomes = before.figures[each.name], after.figures[each.name]
        share = (becomes - was) / (abs(was) or 1.0)
        if abs(share) >= NEXT_TO_NOTHING:
            words = f"{each.name.replace('_', ' ')} {100 * share:+.3g} %"
            (gained if share < 0 else paid).append(words)
    return ", ".join([*gained, *paid]) or "the same"
