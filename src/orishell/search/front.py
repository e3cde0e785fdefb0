"""The front of a search, and which designs are made next."""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Iterator, Sequence
from dataclasses import field
from itertools import islice
from typing import TYPE_CHECKING, Any

import numpy as np

from orishell.conventions.formatting import rounded
from orishell.conventions.record import record
from orishell.design_file.tables import Values
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_smallest
from orishell.search.evaluate import Outcome, violation
from orishell.search.problem import Problem
from orishell.search.space import Space, key_of

if TYPE_CHECKING:
    from pymoo.core.algorithm import Algorithm

NEXT_TO_NOTHING = 5e-4
"""Changes below this share are not worth a word."""


@record
class Front:
    """Designs that no other beats in all objectives at once."""

    # the designs, by their first objective, those equal in it by the next
    members: tuple[Outcome, ...]
    # Which of them is farthest below the plane through the ends of the front, objectives measured
    # by their ranges: to either side a little less of one costs much of another. An end, where none
    # is below it.
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
    """The front of designs that were made; None if none keeps all limits."""
    feasible = [each for each in outcomes if violation(problem, each) == 0.0]
    if not feasible:
        return None
    ordered = sorted(feasible, key=lambda each: (*_compared(problem, each), key_of(each.values)))
    kept = [ordered[k] for k in unbeaten(np.array([_compared(problem, each) for each in ordered]))]
    return Front(tuple(kept), _knee(np.array([scores(problem, each) for each in kept])))


def beaten(problem: Problem, outcomes: Sequence[Outcome], front: Front) -> list[Outcome]:
    """The designs that keep all limits and are not on the front."""
    kept = {key_of(each.values) for each in front.members}
    return [
        each
        for each in outcomes
        if key_of(each.values) not in kept and violation(problem, each) == 0.0
    ]


def scores(problem: Problem, outcome: Outcome) -> tuple[float, ...]:
    """The objectives of a design that was made."""
    return tuple(outcome.figures[each.name] for each in problem.objectives)


def _compared(problem: Problem, outcome: Outcome) -> tuple[float, ...]:
    """The objectives, so rounded that which of equal designs is kept does not hang on rounding."""
    return tuple(rounded(each, 9) for each in scores(problem, outcome))


def unbeaten(points: Array) -> list[int]:
    """Which points no other is at least as good as; of equal ones the first.

    They are (count, objectives), in lexicographic order: none is beaten by a later one.
    """
    kept: list[int] = []
    for k, point in enumerate(points):
        if not (points[kept] <= point).all(axis=1).any():
            kept.append(k)
    return kept


def _knee(points: Array) -> int:
    """Least sum of objectives, each scaled to its range: the plane's normal is (1, ..., 1)."""
    low, high = points.min(axis=0), points.max(axis=0)
    return first_smallest(
        ((points - low) / np.where(high > low, high - low, 1.0)).sum(axis=1), size=1.0
    )


def costs(problem: Problem, before: Outcome, after: Outcome) -> str:
    """What a step from one design to another gains, then what it costs, in words."""
    gained: list[str] = []
    paid: list[str] = []
    for each in problem.objectives:
        was, becomes = before.figures[each.name], after.figures[each.name]
        share = (becomes - was) / (abs(was) or 1.0)
        if abs(share) >= NEXT_TO_NOTHING:
            words = f"{each.name.replace('_', ' ')} {100 * share:+.3g} %"
            (gained if share < 0 else paid).append(words)
    return ", ".join([*gained, *paid]) or "the same"


Chooser = Generator[list[Values], list[Outcome], None]
"""Yields variants to be made, and is sent what became of them, in their order."""
MANY = 3
"""Objectives beyond which NSGA-III is better at keeping a front spread out."""
BATCH = 400
"""Designs of a grid that are asked for together."""


def chooser(problem: Problem) -> Chooser:
    """The method that a search asks for: where it leaves that open, all variants if it may."""
    method, search = problem.search.method, problem.search
    few = method == "auto" and problem.space.count <= search.evaluations
    return _grid(problem) if few or method == "grid" else _bred(problem)


def _grid(problem: Problem) -> Chooser:
    variants: Iterator[Values] = problem.space.grid()
    while batch := list(islice(variants, BATCH)):
        yield batch


def _bred(problem: Problem) -> Chooser:
    """Generations of NSGA-II or III; no variant comes twice."""
    from pymoo.problems.static import StaticProblem

    fresh = _Fresh(problem.space)
    algorithm = _algorithm(problem, fresh)
    left = problem.search.evaluations
    while left > 0:
        population = algorithm.ask()
        if population is None or len(population) == 0:  # breeding finds no others
            rest = (each for each in problem.space.grid() if key_of(each) not in fresh.made)
            if left_over := list(islice(rest, left)):
                yield left_over
            return
        population = population[:left]
        variants = [problem.space.values(point) for point in population.get("X")]
        fresh.made.update(map(key_of, variants))
        outcomes = yield variants
        left -= len(population)
        names = [each.name for each in problem.objectives]
        found = {  # of designs that cannot be made only counts by how much
            "F": np.array([[each.figures.get(name, 0.0) for name in names] for each in outcomes]),
            "G": np.array([[violation(problem, each)] for each in outcomes]),
        }
        algorithm.evaluator.eval(StaticProblem(algorithm.problem, **found), population)
        algorithm.tell(infills=population)


def _algorithm(problem: Problem, fresh: _Fresh) -> Algorithm:
    from pymoo.algorithms.moo.nsga2 import NSGA2
    from pymoo.algorithms.moo.nsga3 import NSGA3
    from pymoo.core.problem import Problem as Posed
    from pymoo.core.termination import NoTermination

    search, space, count = problem.search, problem.space, len(problem.objectives)
    size = min(search.population, search.evaluations)
    many = count > 1 and (search.method == "nsga3" or (search.method == "auto" and count > MANY))
    directions = _directions(count, size) if many else np.empty((0, count))
    size = max(size, len(directions))
    first = _latin(len(space.axes), size, search.seed)
    own = space.point(problem.tables)
    if own is not None:  # the design of the file is worth breeding from
        first[0] = own
    settings: dict[str, Any] = {
        "pop_size": size,
        "sampling": space.snapped(first),
        "repair": _snapping(space),
        "eliminate_duplicates": fresh,
    }
    algorithm = NSGA3(directions, **settings) if many else NSGA2(**settings)
    posed = Posed(n_var=len(space.axes), n_obj=count, n_ieq_constr=1, xl=0.0, xu=1.0)
    algorithm.setup(posed, termination=NoTermination(), seed=search.seed, verbose=False)
    return algorithm


def _latin(sides: int, count: int, seed: int) -> Array:
    """Points of a Latin hypercube, (count, sides): of ``count`` parts of a side, each has one."""
    random = np.random.default_rng(np.random.SeedSequence(seed).spawn(1)[0])  # seed: pymoo's own
    within = random.random((count, sides))
    parts = [random.permutation(count) for _ in range(sides)]
    points: Array = (1 + np.stack(parts, axis=1) - within) / count
    return points


def _directions(objectives: int, size: int) -> Array:
    """Directions spread over the front, (count, objectives): few enough for ``size``, if can be."""
    from pymoo.util.ref_dirs import get_reference_directions

    parts = 1
    while math.comb(objectives + parts, objectives - 1) <= size:
        parts += 1
    found: Array = get_reference_directions("das-dennis", objectives, n_partitions=parts)
    return found


def _snapping(space: Space) -> Callable[..., Any]:
    def snap(_: object, population: Any, **__: object) -> Any:
        if len(population):
            population.set("X", space.snapped(population.get("X")))
        return population

    return snap


@record
class _Fresh:
    """Leaves out of a population what was chosen before."""

    space: Space
    made: set[str] = field(default_factory=set)

    def do(self, population: Any, *others: Any) -> Any:
        known = self.made.union(*map(self._keys, others))
        keys = self._keys(population)
        first = {key: k for k, key in reversed(list(enumerate(keys)))}
        return population[sorted(k for key, k in first.items() if key not in known)]

    def _keys(self, population: Any) -> list[str]:
        return [key_of(self.space.values(each.X)) for each in population]
