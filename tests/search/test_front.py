"""The front, against the definition: a design stays if no other is at least as good in all."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from orishell.search.evaluate import Outcome, reasons, said_of, violation
from orishell.search.front import costs, front_of, unbeaten
from search.problems import small_problem

NAMES = ["panels", "sheet_area", "deviation.f.max"]
PROBLEM = small_problem("parallel-repeating", subject_to={"panels": {"most": 100.0}})


def made(*figures: float, **values: float) -> Outcome:
    return Outcome(values, dict(zip(NAMES, figures, strict=True)))


@given(st.lists(st.tuples(*[st.integers(0, 4)] * 3), min_size=1, max_size=25))
def test_the_front_is_what_no_other_beats(rows: list[tuple[int, int, int]]) -> None:
    outcomes = [made(*map(float, row), n=float(k)) for k, row in enumerate(rows)]
    front = front_of(PROBLEM, outcomes)
    assert front is not None
    found = [tuple(each.figures.values()) for each in front.members]
    points = {tuple(map(float, row)) for row in rows}

    def beaten(point: tuple[float, ...]) -> bool:
        return any(
            other != point and all(a <= b for a, b in zip(other, point, strict=True))
            for other in points
        )

    assert found == sorted(point for point in points if not beaten(point))


def test_the_knee_is_farthest_from_the_line_through_the_ends() -> None:
    curve = [(x, (1 - np.sqrt(x)) ** 2) for x in np.linspace(0, 1, 11)]
    outcomes = [made(100 * x, 7 * y, 0.0) for x, y in curve]
    front = front_of(PROBLEM, outcomes)
    assert front is not None
    # x + y is least at x = 1/4 on (1 - sqrt x)^2; of tenths, 0.2 (0.5056) before 0.3 (0.5046)?
    sums = [x + y for x, y in curve]
    assert front.knee == int(np.argmin(sums))


def test_designs_that_break_limits_or_cannot_be_made_are_not_on_the_front() -> None:
    broken, refused = made(200.0, 0.0, 0.0), Outcome({}, {}, "no", "no, not so", 0.1)
    kept = made(100.0, 1.0, 1.0)
    front = front_of(PROBLEM, [broken, refused, kept])
    assert front is not None
    assert front.members == (kept,)
    assert front_of(PROBLEM, [broken, refused]) is None
    assert reasons(PROBLEM, [broken, refused, refused]) == [("no", 2), ("panels is above 100", 1)]
    assert violation(PROBLEM, broken) < violation(PROBLEM, refused)
    assert said_of(PROBLEM, broken) == "panels is above 100: 200"
    assert said_of(PROBLEM, refused) == "no, not so"


@pytest.mark.parametrize(
    ("before", "after", "words"),
    [
        ((10.0, 2.0, 1.0), (5.0, 2.5, 1.0), "panels -50 %, sheet area +25 %"),
        ((10.0, 2.0, 1.0), (10.0, 1.0, 0.5), "sheet area -50 %, deviation.f.max -50 %"),
        ((10.0, 2.0, 1.0), (10.0, 2.0, 1.0), "the same"),
    ],
)
def test_costs_of_a_step(before: tuple[float, ...], after: tuple[float, ...], words: str) -> None:
    assert costs(PROBLEM, made(*before), made(*after)) == words


def test_of_equal_points_the_first_stays() -> None:
    assert unbeaten(np.array([[1.0, 2.0], [1.0, 2.0], [2.0, 1.0], [3.0, 1.0]])) == [0, 2]
