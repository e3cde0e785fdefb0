"""Vertices along g: where it bends, on its corners, both ends; and on both sides of it."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.optimize import NonlinearConstraint, brentq, minimize

from orishell.curves import Curve, Trace, curve_from_points, trace_curve
from orishell.polylines import Chords, Placement, Spacing, measure_closeness, place_chords
from samples import examples, led_by
from strategies import curves, graph, pair

Array = NDArray[np.float64]

WAVE = graph("5*sin(pi*x/10)", 0, 20)
BEND = np.array([[0, 0], [1, 0.5], [2, 0.3], [3.2, -0.4], [4, 0.2]])
SMOOTH = {
    "wave": WAVE,
    "flat wave": graph("0.25*sin(pi*x/2)", 0, 4),
    "waves": graph("sin(x)", 0, 9.42),
    "exponential": graph("exp(x)", -3, 2),
    "parabola": graph("x**2", -2, 2),
    "half a parabola": graph("x**2", 0, 2),
    "cubic": graph("x**3", -1, 1.3),
    "bell": graph("exp(-x**2)", -3, 3),
    "circle": pair("2*cos(t)", "2*sin(t)", 0, 2.5),
    "ellipse": pair("3*cos(t)", "sin(t)", 0, 3),
    "cycloid": pair("t + 0.5*sin(t)", "cos(0.7*t)", -1, 4),
    "spline": curve_from_points(BEND, smooth=True),
}
FEW = ("wave", "exponential", "circle", "ellipse", "spline")
"""With and without inflections, with even and with uneven curvature."""
MORE = [name for name in SMOOTH if name not in FEW]
spacings = st.sampled_from(["curvature", "equal"])


def distance(trace: Trace, chords: Chords) -> float:
    return measure_closeness(trace, chords.vertices).max


def across(points: Array, start: Array, end: Array) -> Array:
    """Signed distances (..., P) of points (..., P, 2) from lines through (..., 2)."""
    unit = (end - start) / np.linalg.norm(end - start, axis=-1)[..., None]
    away = points - start[..., None, :]
    return np.asarray(unit[..., None, 0] * away[..., 1] - unit[..., None, 1] * away[..., 0])


def sagittas(curve: Curve, t: Array) -> Array:
    part = np.linspace(0, 1, 401)
    vertices = curve.position(t)
    pieces = curve.position(t[:-1, None] * (1 - part) + t[1:, None] * part)
    return np.asarray(np.abs(across(pieces, vertices[:-1], vertices[1:])).max(axis=1))


@given(curves(), st.integers(2, 60), spacings, st.sampled_from(["inscribed", "balanced"]))
def test_vertices_go_from_end_to_end(
    curve: Curve, count: int, spacing: Spacing, placement: Placement
) -> None:
    trace = trace_curve(curve)
    chords = place_chords(trace, count, spacing, placement)
    assert chords.parameters.shape == (count,)
    assert chords.vertices.shape == (count, 2)
    assert (np.diff(chords.parameters) > 0).all()
    assert (chords.parameters[0], chords.parameters[-1]) == (curve.start, curve.stop)
    np.testing.assert_array_equal(chords.vertices[[0, -1]], trace.points[[0, -1]])


def test_equal_spacing_is_equal_in_arc_length() -> None:
    trace = trace_curve(graph("x**2", 0, 2))
    t = place_chords(trace, 9, "equal").parameters
    arcs = [trace_curve(graph("x**2", a, b)).length for a, b in itertools.pairwise(t)]
    np.testing.assert_allclose(arcs, trace.length / 8, rtol=1e-4)
    balanced = place_chords(trace, 9, "equal", "balanced").parameters
    np.testing.assert_array_equal(balanced, t)


def test_circle_has_equal_chords() -> None:
    trace = trace_curve(pair("2*cos(t)", "2*sin(t)", 0, 5))
    np.testing.assert_allclose(np.diff(place_chords(trace, 11).parameters), 0.5, rtol=1e-6)


@pytest.mark.parametrize("name", SMOOTH)
@pytest.mark.parametrize("count", [10, 11, 20, 41])
def test_sagittas_are_equal(name: str, count: int) -> None:
    trace = trace_curve(SMOOTH[name])
    found = sagittas(trace.curve, place_chords(trace, count).parameters)
    # Not where straight parts keep their vertices: the bell's tails with many.
    assert found.max() < 1.05 * found.min()
    if name != "circle":
        equal = place_chords(trace, count, "equal")
        assert found.max() < 0.85 * sagittas(trace.curve, equal.parameters).max()


def least_inscribed(curve: Curve, counts: list[int], grid: int = 320) -> list[float]:
    """The least largest distance of inscribed polylines, their vertices on a grid of points.

    By dynamic programming over the number of edges: independent of curvature and of any guess.
    """
    trace = trace_curve(curve)
    turn = np.concatenate([[0.0], np.cumsum(np.sqrt(np.abs(np.diff(trace.heading))))])
    measure = turn / turn[-1] + trace.arc / trace.length
    points = curve.position(np.interp(np.linspace(0, 2, grid + 1), measure, trace.t))
    edge = np.full((grid + 1, grid + 1), np.inf)
    for i in range(grid):
        ends = points[i + 1 :]
        away = np.abs(across(points[None, i:], points[i], ends))
        inside = np.arange(i, grid + 1) <= np.arange(i + 1, grid + 1)[:, None]
        edge[i, i + 1 :] = np.where(inside, away, 0.0).max(axis=1)
    least, found = edge[0], {}
    for count in range(2, max(counts) + 1):
        found[count] = float(least[-1])
        least = np.maximum(least[:, None], edge).min(axis=0)
    return [found[count] for count in counts]


@pytest.mark.parametrize("name", SMOOTH)
def test_inscribed_polylines_are_the_closest_there_are(name: str) -> None:
    # At an inflection there may be several even polylines, and the closest is not always found.
    trace, counts = trace_curve(SMOOTH[name]), [11, 21]
    found = [distance(trace, place_chords(trace, count)) for count in counts]
    assert (np.array(found) < 1.09 * np.array(least_inscribed(trace.curve, counts))).all()


def test_second_order() -> None:
    trace = trace_curve(WAVE)
    errors = [distance(trace, place_chords(trace, n)) for n in (41, 81, 161)]
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    np.testing.assert_allclose(orders, 2, atol=0.1)


@pytest.mark.parametrize("name", led_by([*FEW, *MORE], len(FEW)))
def test_balanced_polylines_are_nearly_twice_as_close(name: str) -> None:
    trace = trace_curve(SMOOTH[name])
    shares = [
        distance(trace, place_chords(trace, count, placement="balanced"))
        / distance(trace, place_chords(trace, count))
        for count in (11, 12, 14, 20, 30, 41)
    ]
    assert min(shares) > 0.499
    assert np.median(shares) < 0.56
    # Few counts are unlucky: an edge is spent on an inflection.
    assert sorted(shares)[-2] < 0.6
    assert shares[-1] < 0.53


@pytest.mark.parametrize("count", [41, 60, 100])
def test_many_inflections(count: int) -> None:
    trace = trace_curve(graph("sin(x)", 0, 30))
    inscribed = place_chords(trace, count)
    found = sagittas(trace.curve, inscribed.parameters)
    assert found.max() < 1.1 * np.median(found)
    balanced = place_chords(trace, count, placement="balanced")
    assert 0.499 < distance(trace, balanced) / distance(trace, inscribed) < 0.6


@settings(max_examples=examples(60))
@given(curves(), st.integers(2, 40), spacings)
def test_balanced_is_never_farther_than_inscribed(
    curve: Curve, count: int, spacing: Spacing
) -> None:
    trace = trace_curve(curve)
    balanced = place_chords(trace, count, spacing, "balanced")
    assert distance(trace, balanced) <= distance(trace, place_chords(trace, count, spacing))
    off = np.hypot(*(balanced.vertices - curve.position(balanced.parameters)).T)
    at_corner = np.isin(balanced.parameters, trace.t[trace.corners])
    assert not off[at_corner].any()


@pytest.mark.parametrize(("count", "turn"), [(3, 1.0), (4, 1.0), (6, 2.5), (11, 2.5), (40, 5.0)])
def test_balanced_circle(count: int, turn: float) -> None:
    # Vertices at radius R + h, edges tangent to the circle of radius R - h, ends at R.
    trace = trace_curve(pair("2*cos(t)", "2*sin(t)", 0, turn))

    def excess(h: float) -> float:
        half, end = np.arccos((2 - h) / (2 + h)), np.arccos((2 - h) / 2)
        return float(2 * (count - 2) * half + 2 * end - turn)

    found = place_chords(trace, count, placement="balanced")
    h = brentq(excess, 1e-9, 0.5)
    assert distance(trace, found) == pytest.approx(h, rel=1e-3)
    np.testing.assert_allclose(np.hypot(*found.vertices[1:-1].T), 2 + h, atol=1e-3 * h)


@pytest.mark.parametrize(("count", "loss"), [(7, 0.01), (10, 0.01), (11, 0.01)])
def test_balanced_wave_is_optimal(count: int, loss: float) -> None:
    # Against sequential quadratic programming over all parameters and offsets, from several starts.
    trace = trace_curve(WAVE)
    found = place_chords(trace, count, placement="balanced")
    h = distance(trace, found)
    part = np.linspace(0, 1, 42)[1:-1]

    def errors(z: Array) -> Array:
        t = np.concatenate([[trace.t[0]], z[: count - 2], [trace.t[-1]]])
        off = np.concatenate([[0.0], z[count - 2 : -1], [0.0]])
        heading = trace.heading_at(t)
        normal = np.stack([-np.sin(heading), np.cos(heading)], axis=-1)
        vertices = trace.curve.position(t) + off[:, None] * normal
        pieces = trace.curve.position(t[:-1, None] * (1 - part) + t[1:, None] * part)
        away = across(pieces, vertices[:-1], vertices[1:])
        both = np.concatenate([off[1:-1], away.ravel()])
        return np.concatenate([z[-1] - both, z[-1] + both]) / h

    heading = trace.heading_at(found.parameters)
    normal = np.stack([-np.sin(heading), np.cos(heading)], axis=-1)
    off = ((found.vertices - trace.curve.position(found.parameters)) * normal).sum(axis=1)
    best = np.inf
    for seed in range(2):
        noise = np.random.default_rng(seed).normal(size=(2, count - 2)) * min(seed, 1)
        start = np.concatenate([found.parameters[1:-1] + 0.1 * noise[0], off[1:-1]])
        start[count - 2 :] += 0.3 * h * noise[1]
        result = minimize(
            lambda z, *_: float(z[-1] / h),
            np.array([*start, 2 * h], dtype=np.float64),
            constraints=NonlinearConstraint(errors, 0, np.inf),
            method="SLSQP",
            options={"maxiter": 200, "ftol": 1e-6},
        )
        if errors(result.x).min() > -1e-3:
            best = min(best, float(result.x[-1]))
    assert h < (1 + loss) * best


@pytest.mark.parametrize("name", ["parabola", "exponential", "ellipse"])
def test_balanced_overshoots_as_much_as_it_undershoots(name: str) -> None:
    trace = trace_curve(SMOOTH[name])
    balanced = place_chords(trace, 15, placement="balanced")
    off = np.hypot(*(balanced.vertices - trace.curve.position(balanced.parameters)).T)
    np.testing.assert_allclose(off[1:-1], distance(trace, balanced), rtol=1e-3)


def test_balanced_vertex_on_an_inflection_stays_there() -> None:
    trace = trace_curve(WAVE)
    for count in (7, 11, 41):
        middle = place_chords(trace, count, placement="balanced").vertices[count // 2]
        np.testing.assert_allclose(middle, [10, 0], atol=1e-9)


def test_balanced_offsets_fade_towards_an_inflection() -> None:
    # As the wave's end moves, vertices pass the inflection: their offsets never jump.
    offsets = []
    for stop in np.linspace(15, 16, 41):
        trace = trace_curve(graph("5*sin(pi*x/10)", 0, stop))
        balanced = place_chords(trace, 12, placement="balanced")
        away = balanced.vertices - trace.curve.position(balanced.parameters)
        offsets.append(away[:, 1])
    assert np.abs(np.diff(offsets, axis=0)).max() < 0.2 * np.abs(offsets).max()


@settings(max_examples=examples(20))
@given(st.integers(5, 40), st.sampled_from(["inscribed", "balanced"]))
def test_every_corner_of_a_polyline_gets_a_vertex(count: int, placement: Placement) -> None:
    corners = np.array([[0, 0], [1, 2], [4, 2.5], [5, 0], [9, 1]])
    trace = trace_curve(curve_from_points(corners, smooth=False))
    vertices = place_chords(trace, count, placement=placement).vertices
    for corner in corners:
        assert np.hypot(*(vertices - corner).T).min() == pytest.approx(0, abs=1e-12)
    assert measure_closeness(trace, vertices).max < 1e-12


def test_corners_between_curved_pieces_keep_their_vertices() -> None:
    trace = trace_curve(graph("abs(sin(x))", -2, 2.5))
    inscribed, balanced = (
        place_chords(trace, 15, placement=placement) for placement in ("inscribed", "balanced")
    )
    for chords in (inscribed, balanced):
        assert np.hypot(*chords.vertices.T).min() < 1e-6
    assert distance(trace, balanced) < 0.65 * distance(trace, inscribed)


@pytest.mark.parametrize("placement", ["inscribed", "balanced"])
def test_more_corners_than_vertices(placement: Placement) -> None:
    x = np.linspace(0, 3, 200)
    trace = trace_curve(curve_from_points(np.stack([x, np.sin(x)], axis=-1), smooth=False))
    smooth = trace_curve(graph("sin(x)", 0, 3))
    found = distance(trace, place_chords(trace, 9, placement=placement))
    assert found < 1.05 * distance(smooth, place_chords(smooth, 9, placement=placement))


def test_spike_is_not_missed() -> None:
    trace = trace_curve(graph("exp(-10000*(x - 0.4)**2)", -1, 2))
    assert distance(trace, place_chords(trace, 15)) < 0.02


def test_straight_parts_keep_a_fifth_of_the_mean_density() -> None:
    trace = trace_curve(graph("exp(-20*(x - 3)**2)", 0, 12))
    t = place_chords(trace, 31).parameters
    pieces = np.diff(np.interp(t, trace.t, trace.arc))
    assert pieces.max() < 5.01 * pieces.mean()


@settings(max_examples=examples(30))
@given(curves(), st.integers(3, 15), st.sampled_from(["inscribed", "balanced"]))
def test_measured_distance_is_the_true_one_both_ways(
    curve: Curve, count: int, placement: Placement
) -> None:
    trace = trace_curve(curve)
    vertices = place_chords(trace, count, placement=placement).vertices
    part = np.arange(200)[:, None, None] / 200
    along = (vertices[:-1] * (1 - part) + vertices[1:] * part).swapaxes(0, 1).reshape(-1, 2)
    along = np.concatenate([along, vertices[-1:]])
    points = curve.position(np.union1d(np.linspace(curve.start, curve.stop, 2000), curve.breaks))
    square = ((along[:, None] - points) ** 2).sum(axis=-1)
    brute = np.sqrt(max(square.min(axis=0).max(), square.min(axis=1).max()))
    grid = sum(np.hypot(*np.diff(each, axis=0).T).max() for each in (along, points))
    assert measure_closeness(trace, vertices).max == pytest.approx(brute, abs=grid)
