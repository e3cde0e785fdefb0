"""What is kept of functions of a curve, and for how long."""

import pytest

from orishell.conventions.errors import CurveError
from orishell.curves import remembered, trace_curve
from orishell.curves.memo import CURVES, RESULTS
from strategies import graph


def test_a_result_is_kept_for_the_curve_and_the_arguments() -> None:
    asked: list[tuple[object, int]] = []

    @remembered
    def length(curve: object, times: int) -> list[int]:
        asked.append((curve, times))
        return [times]

    one, other = object(), object()
    assert length(one, 2) is length(one, 2)
    assert length(one, 3) == [3]
    assert length(other, 2) is not length(one, 2)
    assert asked == [(one, 2), (one, 3), (other, 2)]


def test_only_the_last_curves_and_results_are_kept() -> None:
    asked: list[tuple[int, int]] = []

    @remembered
    def noted(curve: int, number: int) -> None:
        asked.append((curve, number))

    for curve in range(CURVES):
        noted(curve, 0)
    noted(0, 0)  # now 1 is the one that was asked about longest ago
    noted(CURVES, 0)
    del asked[:]
    noted(0, 0)
    assert asked == []
    noted(1, 0)
    assert asked == [(1, 0)]
    for number in range(RESULTS + 1):
        noted(1, number)
    del asked[:]
    noted(1, 0)
    assert asked == [(1, 0)]


def test_a_refusal_is_made_anew() -> None:
    curve = graph("1/x", -1, 1)
    for _ in range(2):
        with pytest.raises(CurveError):
            trace_curve(curve, "f")


def test_a_trace_is_made_once() -> None:
    curve = graph("x**2", -1, 1)
    assert trace_curve(curve, "f") is trace_curve(curve, "f")
