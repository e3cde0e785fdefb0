"""Curves and their traces: lengths, tangents, corners, and what is refused."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given

from orishell.conventions.errors import CurveError
from orishell.curves import Curve, curve_from_points, trace_curve
from orishell.curves.nearest import Nearest
from orishell.curves.trace import MAX_TURN
from strategies import curves, graph, pair


def test_circle() -> None:
    curve = pair("3*cos(t)", "3*sin(t)", 0.2, 2.2)
    trace = trace_curve(curve)
    assert trace.length == pytest.approx(6.0, abs=1e-12)
    np.testing.assert_allclose(curve.curvature(trace.t), 1 / 3, rtol=1e-12)
    np.testing.assert_allclose(trace.heading, trace.t + np.pi / 2, atol=1e-12)
    assert trace.heading_range() == pytest.approx((0.2 + np.pi / 2, 2.2 + np.pi / 2), abs=1e-12)
    low, high = trace.bounding_box()
    np.testing.assert_allclose(high, [3 * np.cos(0.2), 3.0], atol=1e-4)
    np.testing.assert_allclose(low, [3 * np.cos(2.2), 3 * np.sin(0.2)], atol=1e-12)


def test_parabola_has_the_known_arc_length() -> None:
    # Arc length of y = x**2 on [0, 1]: sqrt(5)/2 + asinh(2)/4.
    trace = trace_curve(graph("x**2", 0, 1))
    assert trace.length == pytest.approx(np.sqrt(5) / 2 + np.arcsinh(2) / 4, abs=1e-12)


def test_steepest_tangent_between_samples_is_found() -> None:
    # The steepest slope of the logistic curve is at its middle, here at no sample.
    trace = trace_curve(graph("tanh(x - 0.1234567)", -3, 2.9))
    assert trace.heading_range()[1] == pytest.approx(np.pi / 4, abs=1e-9)


@given(curves())
def test_samples_turn_by_little_and_lie_on_the_curve(curve: Curve) -> None:
    trace = trace_curve(curve)
    np.testing.assert_array_equal(trace.points, curve.position(trace.t))
    assert np.abs(trace.arriving[1:] - trace.heading[:-1]).max() <= MAX_TURN * (1 + 1e-9)
    assert (np.diff(trace.arc) > 0).all()
    chords = np.hypot(*np.diff(trace.points, axis=0).T)
    assert chords.sum() <= trace.length * (1 + 1e-12)
    assert chords.sum() == pytest.approx(trace.length, rel=1e-5)


@given(curves())
def test_reversed_rotated_and_scaled(curve: Curve) -> None:
    trace = trace_curve(curve)
    back = trace_curve(curve.reversed())
    assert back.length == pytest.approx(trace.length, rel=1e-12)
    np.testing.assert_allclose(back.points[0], trace.points[-1], atol=1e-12)
    turned = trace.rotated(0.3)
    np.testing.assert_allclose(turned.points, turned.curve.position(turned.t), atol=1e-12)
    low, high = trace.heading_range()
    assert turned.heading_range() == pytest.approx((low + 0.3, high + 0.3), abs=1e-6)
    assert trace_curve(curve.scaled(3.0)).length == pytest.approx(3 * trace.length, rel=1e-12)


def test_corners_of_a_polyline_and_of_a_formula() -> None:
    polyline = trace_curve(curve_from_points([[0, 0], [1, 1], [2, 0], [3, 0]], smooth=False))
    np.testing.assert_allclose(polyline.points[polyline.corners], [[1, 1], [2, 0]])
    assert polyline.heading_range() == pytest.approx((-np.pi / 4, np.pi / 4), abs=1e-12)
    assert polyline.length == pytest.approx(2 * np.sqrt(2) + 1, abs=1e-12)
    roof = trace_curve(graph("abs(x - 0.3)", -1, 1))
    np.testing.assert_allclose(roof.points[roof.corners], [[0.3, 0]], atol=1e-6)


@given(curves())
def test_reversed_trace_is_the_trace_of_the_reversed_curve(curve: Curve) -> None:
    back, again = trace_curve(curve).reversed(), trace_curve(curve.reversed())
    assert back.length == pytest.approx(again.length, rel=1e-12)
    assert len(back.corners) == len(again.corners)
    np.testing.assert_allclose(back.points[back.corners], again.points[again.corners], atol=1e-6)
    turn = back.heading[0] - again.heading[0]
    assert np.cos(turn) == pytest.approx(1, abs=1e-9)
    assert back.heading_range() == pytest.approx(
        tuple(turn + bound for bound in again.heading_range()), abs=1e-6
    )
    assert back.curve.as_drawn(back.t[0]) == curve.stop


def test_spline_passes_through_its_points() -> None:
    points = np.array([[0, 0], [1, 0.5], [2, 0.4], [3, 1]])
    curve = curve_from_points(points, smooth=True)
    assert np.hypot(*(Nearest.to(trace_curve(curve))(points)[0] - points).T).max() < 1e-9


@given(curves())
def test_nearest_is_never_farther_than_any_sample(curve: Curve) -> None:
    trace = trace_curve(curve)
    low, high = trace.bounding_box()
    generator = np.random.default_rng(7)
    points = generator.uniform(low - 0.3, high + 0.3, size=(40, 2))
    feet, distance = Nearest.to(trace)(points)
    brute = np.hypot(*np.moveaxis(points[:, None] - trace.points[None], -1, 0)).min(axis=1)
    assert (distance <= brute + 1e-12).all()
    # Not nearer than the curve is: the samples stand close enough for a lower bound.
    spacing = np.diff(trace.arc).max()
    assert (distance >= brute - spacing).all()
    np.testing.assert_allclose(np.hypot(*(points - feet).T), distance, atol=1e-12)


def test_nearest_on_a_spike_is_not_fooled_by_the_other_flank() -> None:
    trace = trace_curve(graph("exp(-10000*x**2)", -1, 1))
    points = np.array([[0.004, 0.8], [-0.006, 0.7]])
    dense = trace.curve.position(np.linspace(-0.05, 0.05, 400_001))
    brute = np.hypot(*np.moveaxis(points[:, None] - dense[None], -1, 0)).min(axis=1)
    np.testing.assert_allclose(Nearest.to(trace)(points)[1], brute, atol=1e-6)


@pytest.mark.parametrize(
    ("curve", "says"),
    [
        (lambda: graph("1/x", -1, 1), "not finite"),
        (lambda: graph("1/x", -1, 1.1), "jumps"),
        (lambda: graph("tan(x)", 0, 3), "jumps"),
        (lambda: graph("abs(x)/x", -1, 1.1), "jumps"),
        (lambda: graph("log(x)", 0, 1), "not finite"),
        (lambda: graph("sqrt(x)", 0, 1), "tangent is not finite"),
        (lambda: graph("sqrt(x - 2)", 0, 1), "not finite"),
        (lambda: pair("t**2", "t**3", -1, 1.3), "not regular"),
        (lambda: pair("t**3", "t**3", -1, 1.1), "not regular"),
        # Beside that place the tangent is no number: 0/0.
        (lambda: pair("20*(t-0.3)**3", "-20*sqrt((t-0.3)**6)", -0.4, 1), "not regular"),
        (lambda: pair("1", "2", 0, 1), "single point"),
        (lambda: graph("x", 1e9, 1e9 + 0.1), "too short"),
        (lambda: graph("sin(1e6*x)", 0, 1), "turns too often"),
        (lambda: curve_from_points([[0, 0], [1, 0], [0, 0]], smooth=False), "turns back"),
        (lambda: graph("x", 0, 1).scaled(1e300), "not finite"),
        (lambda: graph("x", 0, 1).scaled(1e-300), "too short"),
        (lambda: graph("x", 2, 1), "reversed"),
        (lambda: graph("x", 1, 1), "empty"),
        (lambda: graph("x", 0, np.inf), "not a finite number"),
        (lambda: graph("x", np.nan, 1), "not a finite number"),
        (lambda: pair("t", "x", 0, 1), "different variables"),
        (lambda: curve_from_points([[0, 0]], smooth=True), "too few points"),
        (lambda: curve_from_points([[0, 0], [0, 0], [1, 1]], smooth=True), "coincide"),
        (lambda: curve_from_points([[0.0, 0.0], [float("nan"), 0.0]], smooth=True), "not finite"),
    ],
)
def test_unusable_curves_are_refused(curve: Callable[[], Curve], says: str) -> None:
    with pytest.raises(CurveError, match=says):
        trace_curve(curve())
