"""Zigzags: alternating turns, vertices on the offsets, ends kept."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.curves import Curve, run_along_axis, trace_curve
from orishell.curves.nearest import Nearest
from orishell.polylines import choose_depth, place_zigzag, place_zigzags, smallest_radius
from orishell.polylines.zigzag import KEPT
from samples import examples
from strategies import arcs, curves, cycloids, graph, graphs, numbers, pair, points

PARABOLA = trace_curve(graph("-x**2", -1, 1))


@settings(max_examples=examples(80))
@given(curves(), numbers(0.05, 1.0), st.integers(0, 20))
def test_alternates_and_keeps_the_ends(curve: Curve, share: float, half: int) -> None:
    trace = trace_curve(curve)
    inner = 2 * half + 1
    for zigzag in place_zigzags(trace, inner, share * trace.length / inner):
        np.testing.assert_array_equal(zigzag.vertices[[0, -1]], trace.points[[0, -1]])
        edges = np.diff(zigzag.vertices, axis=0) @ np.array([1, 1j])
        turn = np.angle(edges[1:] / edges[:-1])
        assert (np.sign(turn) == -zigzag.first * (-1.0) ** np.arange(inner)).all()
        np.testing.assert_allclose(zigzag.angles, np.pi - np.abs(turn), atol=1e-12)
        away = np.linalg.norm(zigzag.vertices - zigzag.feet, axis=1)
        np.testing.assert_allclose(away[1:-1], zigzag.depth, rtol=1e-9)


@settings(max_examples=examples(40))
@given(st.one_of(graphs(), arcs(), points(smooth=True), cycloids()), numbers(0.05, 0.99))
def test_vertices_lie_on_the_offsets(curve: Curve, share: float) -> None:
    # Within the radius of curvature the foot is the locally nearest point: square to the tangent.
    trace = trace_curve(curve)
    depth = share * min(smallest_radius(trace)[0], trace.length)
    zigzag = place_zigzag(trace, 9, depth)
    foot, distance = Nearest.to(trace)(zigzag.vertices[1:-1])
    assert (distance <= depth * (1 + 1e-9)).all()
    near = np.abs(distance - depth) < 1e-6 * depth
    np.testing.assert_allclose(foot[near], zigzag.feet[1:-1][near], atol=1e-3 * trace.length)


def test_smallest_radius() -> None:
    radius, place = smallest_radius(PARABOLA)
    assert radius == pytest.approx(0.5, rel=1e-4)  # 1/|f''(0)|
    assert place == pytest.approx(0.0, abs=0.01)
    assert smallest_radius(trace_curve(graph("0.3*x", 0, 2)))[0] == np.inf
    # Corners do not count.
    assert smallest_radius(trace_curve(graph("abs(x)", -1, 1.1)))[0] > 1e3


def test_mean_angle_of_the_auto_depth() -> None:
    for text in ("-x**2", "0.3*x", "0.2*sin(3*x)"):
        trace = trace_curve(graph(text, -1, 1))
        depth = choose_depth(trace, 31)
        both = [place_zigzag(trace, 31, depth, first).angles.mean() for first in (1, -1)]
        assert np.mean(both) == pytest.approx(np.pi / 2, abs=1e-9)
    # Where that is deeper than the offsets reach, 0.9 of the smallest radius of curvature.
    assert choose_depth(PARABOLA, 1) == pytest.approx(0.45, rel=1e-4)


def test_zigzag_of_a_straight_line_is_even() -> None:
    zigzag = place_zigzag(trace_curve(graph("0.3*x", 0, 2)), 9, 0.1)
    np.testing.assert_allclose(zigzag.angles, zigzag.angles[0], atol=1e-9)
    reach = zigzag.reach()
    assert reach > 1e6  # even angles: columns may be shifted as far as one likes


def test_zigzag_of_a_circle_is_even_on_either_side() -> None:
    circle = trace_curve(pair("-cos(t)", "sin(t)", 0.3, 2.8))
    angles = place_zigzag(circle, 11, 0.1).angles[1:-1]
    np.testing.assert_allclose(angles[2:], angles[:-2], atol=1e-6)


def test_symmetric_curve_has_a_symmetric_zigzag() -> None:
    for zigzag in place_zigzags(PARABOLA, 9, 0.12):
        mirrored = zigzag.vertices[::-1] * [-1, 1]
        np.testing.assert_allclose(mirrored, zigzag.vertices, atol=1e-9)
        assert abs(zigzag.axis) < 1e-12


def test_shift_limits_are_where_an_edge_vanishes() -> None:
    for zigzag in place_zigzags(PARABOLA, 9, 0.12):
        growth = np.diff(np.tan(zigzag.angles / 2))
        inner = zigzag.lengths[1:-1]
        for limit in zigzag.shift_limits():
            share = (inner + growth * limit) / inner
            assert share.min() == pytest.approx(KEPT, abs=1e-12)


def test_too_shallow_does_not_alternate() -> None:
    assert place_zigzags(PARABOLA, 9, 1e-4) == []
    assert not place_zigzag(PARABOLA, 9, 1e-4).is_alternating


def test_curves_are_run_through_along_their_axis() -> None:
    leftwards = trace_curve(pair("-t", "-t**2 + 0.1*t", -1, 1))
    rightwards = run_along_axis(leftwards)
    np.testing.assert_allclose(rightwards.points, leftwards.points[::-1], atol=1e-12)
    assert np.abs(rightwards.heading).max() < np.pi / 2
    assert run_along_axis(leftwards, np.pi).points[0, 0] == leftwards.points[0, 0]
