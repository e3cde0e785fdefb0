"""The journal of the searched shelter is whole, and of the shelter as it is now."""

from __future__ import annotations

import runpy
from collections.abc import Sequence
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.search import Outcome, Problem, SearchResult, WorkerPool, read_problem
from orishell.search.evaluate import evaluate, job_of, violation
from orishell.search.worker_pool import Work
from samples import thorough

EXAMPLES = Path(__file__).parents[2] / "examples"
AGREE = 1e-6
"""Relative: linear systems are solved with other roundings on other machines."""


class Nobody:
    """A place where no work may be done."""

    died: tuple[type[BaseException], ...] = ()

    def submit(self, work: Work, chunk: Sequence[Any]) -> Future[list[Any]]:
        """Say what was to be done."""
        raise AssertionError(f"not in the journal: {chunk}")

    def renew(self) -> None:
        """Nobody dies."""


@pytest.fixture(scope="module")
def example() -> dict[str, Any]:
    return runpy.run_path(str(EXAMPLES / "shelter_search.py"))


@pytest.fixture(scope="module")
def problem() -> Problem:
    return read_problem(EXAMPLES / "shelter_search.toml")


@pytest.fixture(scope="module")
def found(example: dict[str, Any], problem: Problem) -> SearchResult:
    """What the search finds with nobody to make a design."""
    result: SearchResult = example["find"](problem, WorkerPool([Nobody()]))
    return result


def test_the_journal_is_whole(
    example: dict[str, Any], problem: Problem, found: SearchResult
) -> None:
    assert found.whole
    assert len(found.outcomes) == problem.search.evaluations
    lines = example["MADE"].read_bytes().splitlines()
    assert len(lines) == 2 + len(found.outcomes)  # its head, and the design to begin with


def test_the_front_keeps_the_limits(problem: Problem, found: SearchResult) -> None:
    assert len(found.front.members) > 5
    assert all(each.figures["deflection"] <= 0.06 for each in found.front.members)
    assert all(each.figures["utilisation"] <= 1 for each in found.front.members)
    made = [each.figures for each in found.outcomes if each.figures]
    assert any(each["deflection"] <= 0.06 and each["utilisation"] > 1 for each in made)
    assert any(violation(problem, each) > 0 for each in found.outcomes)


@thorough
@pytest.mark.slow
def test_designs_of_the_front_are_made_again(
    example: dict[str, Any], problem: Problem, found: SearchResult
) -> None:
    picked: dict[str, Outcome] = example["chosen"](problem, found)
    kept = [picked["lightest"], picked["knee"]]
    for was, now in zip(kept, evaluate(job_of(problem), [e.values for e in kept]), strict=True):
        assert not now.reason, now.said
        assert now.figures == pytest.approx(was.figures, rel=AGREE)


def test_stiff_ones_have_a_ridge_and_those_that_pack_small_a_valley(
    example: dict[str, Any], problem: Problem, found: SearchResult
) -> None:
    picked: dict[str, Outcome] = example["chosen"](problem, found)

    def rise(name: str) -> float:
        """Of the middle row above those beside it, on the mean."""
        sheet = example["design"](problem, picked[name]).design.mechanism
        heights = sheet.positions(sheet.target_drive)[..., 2].mean(axis=1)
        middle = len(heights) // 2
        return float(heights[middle] - np.mean(heights[[middle - 1, middle + 1]]))

    assert rise("smallest pack") < -0.1
    assert rise("stiffest") > 0.1


def test_the_example_prints_its_choice(
    example: dict[str, Any],
    problem: Problem,
    found: SearchResult,
    capsys: pytest.CaptureFixture[str],
) -> None:
    example["main"]()
    first, _, *rows = capsys.readouterr().out.splitlines()
    count = len(found.front.members)
    assert first == f"{len(found.outcomes)} designs, {count} that no other beats"
    picked: dict[str, Outcome] = example["chosen"](problem, found)
    assert [line[:15].rstrip() for line in rows] == [*picked]
    for line, outcome in zip(rows, picked.values(), strict=True):
        assert f"{outcome.figures['mass']:.0f} kg" in line
