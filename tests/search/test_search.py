"""What a search finds, against all variants made one by one; and how it ends where it must."""

from __future__ import annotations

import threading
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import DesignError, InputError
from orishell.search.evaluate import Outcome, _common, evaluate, job_of, violation
from orishell.search.front import chooser, scores
from orishell.search.journal import Journal, journal_in_memory
from orishell.search.problem import Problem
from orishell.search.run import SearchResult, search_designs
from orishell.search.worker_pool import WorkerPool, alone, local_processes
from samples import led_by
from search.problems import GRIDS, small_problem

SHARE = 0.8
"""Of all variants, so many are bred."""


def searched(
    problem: Problem, journal: Journal | None = None, pool: WorkerPool | None = None
) -> SearchResult:
    journal = journal or journal_in_memory()
    if pool is not None:
        return search_designs(problem, pool, journal)
    with alone() as one:
        return search_designs(problem, one, journal)


def front(problem: Problem, found: SearchResult) -> list[tuple[float, ...]]:
    return [scores(problem, each) for each in found.front.members]


@pytest.mark.slow
@pytest.mark.parametrize("family", led_by(GRIDS))
def test_the_front_is_that_of_all_variants(family: str) -> None:
    grid = small_problem(family, method="grid")
    journal = journal_in_memory()
    with local_processes(2) as pool:
        every = searched(grid, journal, pool)
    assert len(every.outcomes) == grid.space.count
    bred = small_problem(
        family, method="nsga2", population=10, evaluations=int(SHARE * grid.space.count)
    )
    found = searched(bred, journal)
    assert len({str(each.values) for each in found.outcomes}) == bred.search.evaluations
    assert len(every.front.members) > 2
    assert front(bred, found) == front(grid, every)


def made_up(
    problem: Problem, figures: dict[str, Any], evaluations: int | None = None
) -> list[Outcome]:
    """The outcomes of a search whose designs are functions of their values."""
    chosen = chooser(problem)
    outcomes: list[Outcome] = []
    batch = next(chosen, None)
    while batch is not None:
        made = [
            Outcome(each, {name: rule(*each.values()) for name, rule in figures.items()})
            for each in batch
        ]
        outcomes += made
        try:
            batch = chosen.send(made)
        except StopIteration:
            break
    return outcomes


@pytest.mark.parametrize(("method", "most"), [("nsga2", 0.02), ("nsga3", 0.02)])
def test_a_known_front_is_found(method: str, most: float) -> None:
    """Of x and (1 - sqrt x) (1 + 9 y), the front is y = 0 (the function ZDT1 of Zitzler, 2000)."""
    problem = small_problem(
        "parallel-repeating",
        variables={
            "target.f.scale": {"low": 1e-9, "high": 1.0},
            "pattern.flap": {"low": 0.0, "high": 1.0},
        },
        minimise=["panels", "mass"],
        evaluations=800,
        method=method,
    )
    outcomes = made_up(
        problem,
        {"panels": lambda x, _: x, "mass": lambda x, y: 1 + 9 * y - np.sqrt(x * (1 + 9 * y))},
    )
    assert len(outcomes) == 800
    assert len({str(each.values) for each in outcomes}) == 800
    assert all(1e-9 <= each.values["target.f.scale"] <= 1 for each in outcomes)
    best = sorted((each.figures["panels"], each.figures["mass"]) for each in outcomes)
    area, level = 0.0, 1.1
    for (x, y), after in zip(best, [*(each[0] for each in best[1:]), 1.1], strict=True):
        level = min(level, y)
        area += (min(after, 1.1) - min(x, 1.1)) * (1.1 - level)
    whole = 1.1 * 1.1 - 0.1 * 0 - (1 - 2 / 3)  # below (1.1, 1.1), above 1 - sqrt x up to 1, then 0
    assert area > (1 - most) * whole


@pytest.mark.parametrize(("objectives", "population"), [(1, 4), (2, 4), (4, 4), (5, 30)])
@pytest.mark.parametrize("method", ["auto", "nsga2", "nsga3"])
def test_any_number_of_objectives(
    objectives: int, population: int, method: str, capfd: pytest.CaptureFixture[str]
) -> None:
    names = ["panels", "mass", "sheet_area", "cut_length", "crease_length"][:objectives]
    problem = small_problem(
        "parallel-repeating",
        variables={"pattern.flap": {"low": 0.0, "high": 1.0}},
        minimise=names,
        evaluations=3 * population,
        population=population,
        method=method,
    )
    figures = {name: lambda x, k=k: (x - k / 5) ** 2 for k, name in enumerate(names)}
    assert len(made_up(problem, figures)) == 3 * population
    assert capfd.readouterr() == ("", "")


def test_the_first_generation_is_spread_over_each_range() -> None:
    ranges = {
        "target.f.scale": {"low": 1.0, "high": 9.0},
        "pattern.flap": {"low": 1.0, "high": 9.0},
    }
    problem = small_problem("parallel-repeating", variables=ranges, population=8, evaluations=8)
    first = next(chooser(problem))
    for key in ranges:
        assert sorted(int(each[key]) for each in first) == [1, 2, 3, 4, 5, 6, 7, 8]


def test_refusals_that_miss_by_less_are_nearer() -> None:
    problem = small_problem("orthodiagonal", subject_to={"panels": {"most": 100.0, "least": 10.0}})
    values: dict[str, Any] = {}
    figures = {"panels": 50.0, "deviation.f.max": 1.0}
    feasible = Outcome(values, figures)
    above = Outcome(values, {**figures, "panels": 150.0})
    far = Outcome(values, {**figures, "panels": 1000.0})
    below = Outcome(values, {**figures, "panels": 5.0})
    refused = [Outcome(values, {}, "no", "no", excess) for excess in (0.0, 0.5, 10.0, None)]
    sizes = [violation(problem, each) for each in (feasible, below, above, far, *refused)]
    assert sizes[0] == 0.0
    assert sizes[1] == sizes[2] == pytest.approx(1 / 3)
    assert sizes[2:] == sorted(sizes[2:])
    assert len(set(sizes[2:])) == len(sizes[2:])


def test_all_variants_are_made_where_they_are_few() -> None:
    problem = small_problem("orthodiagonal", variables={"pattern.rows": [3, 5]})
    found = searched(problem)
    assert [each.values for each in found.outcomes] == [{"pattern.rows": 3}, {"pattern.rows": 5}]
    assert found.whole
    assert found.baseline.values == {}


def test_a_search_without_a_feasible_design_says_why_and_what_is_nearest() -> None:
    problem = small_problem(
        "orthodiagonal",
        variables={"pattern.rows": [5, 9], "pattern.flap": [0.1, 50.0]},
        subject_to={"panels": {"most": 3.0}},
    )
    with pytest.raises(DesignError, match="no design was found") as error:
        searched(problem)
    message = str(error.value)
    assert "2 of 4: the flaps are too wide" in message
    assert "2 of 4: panels is above 3" in message
    assert "The nearest, with pattern.rows = 5, pattern.flap = 0.1: panels is above 3" in message


def test_a_figure_that_the_design_does_not_have_is_refused_before_the_search() -> None:
    problem = small_problem("orthodiagonal", minimise=["mass"])
    told: list[float] = []
    with alone() as pool, pytest.raises(InputError, match="does not say mass"):
        search_designs(problem, pool, journal_in_memory(), lambda share, _: told.append(share))
    assert not told


def test_a_search_that_is_stopped_has_what_there_is_and_goes_on_from_there() -> None:
    problem = small_problem(
        "orthodiagonal",
        variables={"pattern.rows": [3, 5], "pattern.depth": {"low": 0.06, "high": 0.15}},
        minimise=["panels", "sheet_area"],
        method="nsga2",
        population=4,
        evaluations=10,
    )
    journal = journal_in_memory()
    stop = threading.Event()
    seen: list[Outcome] = []

    def see(outcome: Outcome) -> None:
        seen.append(outcome)
        if len(seen) == 6:
            stop.set()

    with alone() as pool:
        half = search_designs(problem, pool, journal, stop=stop, seen=see)
        assert not half.whole
        assert 5 <= len(half.outcomes) < 10
        assert len(journal) == 1 + len(half.outcomes)
        whole = search_designs(problem, pool, journal)
    assert whole.whole
    assert whole.outcomes == searched(problem).outcomes
    assert whole.outcomes[: len(half.outcomes)] == half.outcomes


def test_progress_ends_with_the_search() -> None:
    told: list[float] = []
    problem = small_problem("orthodiagonal", method="nsga2", population=4, evaluations=6)
    with alone() as pool:
        search_designs(problem, pool, journal_in_memory(), lambda share, _: told.append(share))
    assert told == sorted(told)
    assert told[-1] == 1.0


def test_a_fault_in_one_design_does_not_end_the_search(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*_: object) -> None:
        raise ZeroDivisionError("by zero")

    monkeypatch.setattr("orishell.search.evaluate.report_of", broken)
    problem = small_problem("orthodiagonal")
    (outcome,) = evaluate(job_of(problem), [{"pattern.rows": 3}])
    assert outcome.reason == "a fault of the program"
    assert outcome.said == "ZeroDivisionError: by zero"


@pytest.mark.parametrize(
    ("condition", "reason"),
    [
        ("xi_deg = 58.7203 is too large for f", "xi_deg is too large for f"),
        ("column 3 would be narrower than 1e-3", "column ... would be narrower than ..."),
        ("at heading_deg = -7.5 g runs too far", "at heading_deg g runs too far"),
        ("the angle alpha2 closes", "the angle alpha2 closes"),
    ],
)
def test_reasons_have_no_numbers(condition: str, reason: str) -> None:
    assert _common(condition) == reason
