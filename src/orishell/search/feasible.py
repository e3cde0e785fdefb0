"""Whether a variant can be made and keeps all limits: by how much it does not, and why."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence

from orishell.conventions.quantities import plain
from orishell.design_file.search import Limit
from orishell.search.evaluate import Outcome
from orishell.search.problem import Problem


def violation(problem: Problem, outcome: Outcome) -> float:
    """By how much a variant breaks limits, 0 if it is feasible.

    Up to 1 if it can be made, its figures relative to their limits; up to 2 if a refusal says by
    how much it fails, and 3 where nothing is known.

    Parameters
    ----------
    problem
        The limits.
    outcome
        What became of the variant.
    """
    if outcome.reason:
        return 3.0 if outcome.excess is None else 1.0 + _squeezed(outcome.excess)
    broken = sum(_beyond(limit, outcome.figures[each.name]) for each, limit in problem.limits)
    return _squeezed(broken)


def reasons(problem: Problem, outcomes: Sequence[Outcome]) -> list[tuple[str, int]]:
    """Why designs are not feasible, the commonest first, and how many it applies to.

    Parameters
    ----------
    problem
        The limits.
    outcomes
        The designs.
    """
    counted: Counter[str] = Counter()
    for each in outcomes:
        if each.reason:
            counted[each.reason] += 1
        else:
            counted.update(words for _, words in _broken(problem, each))
    return sorted(counted.items(), key=lambda each: (-each[1], each[0]))


def asked_of_loads(problem: Problem) -> str:
    """What designs that keep all limits do under loads: no more than was looked at.

    Parameters
    ----------
    problem
        The limits.
    """
    limit = next((limit for figure, limit in problem.limits if figure.name == "utilisation"), None)
    if limit is None:
        return "loads were not looked at: the design file has no [structure]"
    if limit.most is None or limit.most > 1:
        return "utilisation may be above 1, as the design file asks: such a shell buckles or breaks"
    return (
        f"under loads a utilisation of at most {limit.most:g}, of the strengths in the design file "
        "and of buckling, by linear analysis"
    )


def nearest(problem: Problem, outcomes: Sequence[Outcome]) -> Outcome:
    """The design that misses its limits by least."""
    return min(outcomes, key=lambda each: violation(problem, each))


def said_of(problem: Problem, outcome: Outcome) -> str:
    """Why a design is not feasible."""
    return outcome.said or "; ".join(
        f"{words}: {plain(outcome.figures[name])}" for name, words in _broken(problem, outcome)
    )


def _broken(problem: Problem, outcome: Outcome) -> list[tuple[str, str]]:
    """The figures whose limits a design breaks, and these in words."""
    return [
        (figure.name, f"{figure.name} is {'above' if above else 'below'} {end:g}")
        for figure, limit in problem.limits
        for above, end in ((True, limit.most), (False, limit.least))
        if end is not None
        and (outcome.figures[figure.name] > end if above else outcome.figures[figure.name] < end)
    ]


def _beyond(limit: Limit, value: float) -> float:
    over = 0.0 if limit.most is None else (value - limit.most) / (abs(limit.most) or 1.0)
    under = 0.0 if limit.least is None else (limit.least - value) / (abs(limit.least) or 1.0)
    return max(over, under, 0.0)


def _squeezed(size: float) -> float:
    return 1.0 if math.isinf(size) else size / (1.0 + size)
