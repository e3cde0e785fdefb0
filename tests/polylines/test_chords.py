"""Vertices on g: where it bends, on its corners, and both ends."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.curves import Curve, curve_from_points, trace_curve
from orishell.polylines import Spacing, measure_closeness, place_vertices
from strategies import curves, graph, pair


@given(curves(), st.integers(2, 60), st.sampled_from(["curvature", "equal"]))
def test_vertices_go_from_end_to_end(curve: Curve, count: int, spacing: Spacing) -> None:
    trace = trace_curve(curve)
    t = place_vertices(trace, count, spacing)
    assert len(t) == count
    assert (np.diff(t) > 0).all()
    assert (t[0], t[-1]) == (curve.start, curve.stop)


def test_equal_spacing_is_equal_in_arc_length() -> None:
    trace = trace_curve(graph("x**2", 0, 2))
    t = place_vertices(trace, 9, "equal")
    arcs = [trace_curve(graph("x**2", a, b)).length for a, b in itertools.pairwise(t)]
    np.testing.assert_allclose(arcs, trace.length / 8, rtol=1e-4)


def test_circle_has_equal_chords() -> None:
    trace = trace_curve(pair("2*cos(t)", "2*sin(t)", 0, 5))
    np.testing.assert_allclose(np.diff(place_vertices(trace, 11)), 0.5, rtol=1e-6)


def test_sagittas_are_nearly_equal_where_curvature_varies() -> None:
    trace = trace_curve(graph("exp(x)", -3, 2))
    t = place_vertices(trace, 41)
    vertices = trace.curve.position(t)
    middle = trace.curve.position(0.5 * (t[:-1] + t[1:]))
    chord = np.diff(vertices, axis=0)
    offset = middle - vertices[:-1]
    cross = chord[:, 0] * offset[:, 1] - chord[:, 1] * offset[:, 0]
    sagitta = np.abs(cross) / np.hypot(*chord.T)
    assert sagitta.max() < 4 * np.median(sagitta)
    equal = trace.curve.position(place_vertices(trace, 41, "equal"))
    assert measure_closeness(trace, vertices).max < 0.5 * measure_closeness(trace, equal).max


def test_second_order() -> None:
    trace = trace_curve(graph("5*sin(pi*x/10)", 0, 20))
    errors = [
        measure_closeness(trace, trace.curve.position(place_vertices(trace, n))).max
        for n in (41, 81, 161)
    ]
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    np.testing.assert_allclose(orders, 2, atol=0.1)


@settings(max_examples=20)
@given(st.integers(5, 40))
def test_every_corner_of_a_polyline_gets_a_vertex(count: int) -> None:
    corners = np.array([[0, 0], [1, 2], [4, 2.5], [5, 0], [9, 1]])
    trace = trace_curve(curve_from_points(corners, smooth=False))
    vertices = trace.curve.position(place_vertices(trace, count))
    for corner in corners:
        assert np.hypot(*(vertices - corner).T).min() == pytest.approx(0, abs=1e-12)
    assert measure_closeness(trace, vertices).max < 1e-12


def test_more_corners_than_vertices() -> None:
    x = np.linspace(0, 3, 200)
    trace = trace_curve(curve_from_points(np.stack([x, np.sin(x)], axis=-1), smooth=False))
    smooth = trace_curve(graph("sin(x)", 0, 3))
    found = trace.curve.position(place_vertices(trace, 9))
    ideal = smooth.curve.position(place_vertices(smooth, 9))
    assert measure_closeness(trace, found).max < 2.5 * measure_closeness(smooth, ideal).max


def test_spike_is_not_missed() -> None:
    trace = trace_curve(graph("exp(-10000*(x - 0.4)**2)", -1, 2))
    vertices = trace.curve.position(place_vertices(trace, 15))
    assert measure_closeness(trace, vertices).max < 0.02
