"""Staircases: constant angle, ends kept, least distance."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.curves import Curve, Trace, trace_curve
from orishell.curves.nearest import Nearest
from orishell.polylines import (
    Staircase,
    choose_theta,
    choose_xi,
    fit_staircase,
    measure_closeness,
    theta_interval,
    xi_limit,
)
from orishell.polylines.closeness import distances_to_polyline
from orishell.polylines.staircase import (
    Search,
    batched,
    rotated_search,
    run_search,
    search_staircase,
)
from orishell.polylines.staircase_angles import MIN_EVENNESS, WIDEST_XI
from samples import examples
from strategies import curves, graph, numbers, points

PARABOLA_LIMIT = 2 * np.arctan(0.5)
"""Slope 2 at the ends of -x**2 on [-1, 1] (geometry.md section 3: 53.13 degrees)."""


def along_axis(curve: Curve) -> Trace:
    """The curve rotated so that its tangents are centred on the x axis."""
    trace = trace_curve(curve)
    low, high = trace.heading_range()
    return trace.rotated(-0.5 * (low + high))


def brute_hausdorff(trace: Trace, vertices: np.ndarray) -> float:
    part = np.linspace(0, 1, 200)[:, None, None]
    along = (vertices[:-1] * (1 - part) + vertices[1:] * part).reshape(-1, 2)
    return float(
        max(
            distances_to_polyline(trace.points, vertices).max(),
            distances_to_polyline(along, trace.points).max(),
        )
    )


@settings(max_examples=examples(80))
@given(curves(), numbers(0.05, 0.97), st.integers(2, 40))
def test_staircase_of_any_curve(curve: Curve, share: float, count: int) -> None:
    trace = along_axis(curve)
    limit = xi_limit(*trace.heading_range())
    xi = share * limit
    staircase = fit_staircase(trace, xi, count)
    size = trace.length
    # Ends kept, angle constant, edges positive and alternating.
    np.testing.assert_allclose(
        staircase.vertices[[0, -1]], trace.points[[0, -1]], atol=1e-12 * size
    )
    edges = np.diff(staircase.vertices, axis=0)
    direction = np.arctan2(edges[:, 1], edges[:, 0])
    np.testing.assert_allclose(np.abs(direction), (np.pi - xi) / 2, atol=1e-9)
    assert (np.sign(direction[1:]) == -np.sign(direction[:-1])).all()
    np.testing.assert_allclose(np.hypot(*edges.T), staircase.lengths, rtol=1e-9)
    # All corners equally far, and that is the Hausdorff distance, found by brute force.
    assert staircase.balanced
    spacing = np.diff(trace.arc).max()
    brute = brute_hausdorff(trace, staircase.vertices)
    assert staircase.distance == pytest.approx(brute, abs=1e-5 * size + 1e-2 * spacing)


@settings(max_examples=examples(40))
@given(st.one_of(curves(), points(smooth=False)), numbers(0.2, 0.9), st.integers(2, 8), st.data())
def test_no_other_staircase_is_closer(
    curve: Curve, share: float, half: int, data: st.DataObject
) -> None:
    trace = along_axis(curve)
    xi = share * xi_limit(*trace.heading_range())
    best = fit_staircase(trace, xi, 2 * half)
    # Move edges of either direction at random: the distance does not fall.
    sin, cos = np.sin(xi / 2), np.cos(xi / 2)
    for seed in data.draw(st.lists(st.integers(0, 999), min_size=3, max_size=3)):
        generator = np.random.default_rng(seed)
        scale = 10.0 ** generator.uniform(-4, -0.5) * best.lengths.mean()
        shift = np.zeros(2 * half)
        shift[1:-1] = generator.normal(size=2 * half - 2) * scale
        lengths = best.lengths.copy()
        lengths[:-1] += shift[1:]
        lengths[1:] -= shift[:-1]
        if lengths.min() <= 0:
            continue
        sign = best.first * np.where(np.arange(2 * half) % 2 == 0, 1, -1)
        steps = lengths[:, None] * np.stack([np.full(2 * half, sin), sign * cos], axis=-1)
        other = trace.points[0] + np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)])
        assert brute_hausdorff(trace, other) >= best.distance * (1 - 1e-3)


def test_distance_falls_with_the_number_of_edges() -> None:
    # First order (geometry.md section 3): m times the distance converges.
    trace = trace_curve(graph("-x**2", -1, 1))
    products = [
        m * fit_staircase(trace, np.deg2rad(50), m + 1).distance for m in (31, 63, 127, 255, 511)
    ]
    assert np.abs(np.diff(products)).max() < 0.01 * products[-1]


def test_symmetric_curve_has_a_symmetric_staircase() -> None:
    staircase = fit_staircase(trace_curve(graph("-x**2", -1, 1)), np.deg2rad(50), 10)
    np.testing.assert_allclose(staircase.lengths, staircase.lengths[::-1], rtol=1e-8)
    assert staircase.first == 1


def test_xi_limit_of_the_parabola() -> None:
    limit = xi_limit(*trace_curve(graph("-x**2", -1, 1)).heading_range())
    assert limit == pytest.approx(PARABOLA_LIMIT, abs=1e-12)
    assert np.rad2deg(limit) == pytest.approx(53.13, abs=0.005)


@given(numbers(-1.2, 0), numbers(0, 1.2), numbers(0.05, 3))
def test_theta_interval_is_where_xi_is_below_the_limit(low: float, high: float, xi: float) -> None:
    begin, end = theta_interval(low, high, xi)
    for theta in np.linspace(-2, 2, 41):
        inside = begin < theta < end
        assert (
            inside == (xi < xi_limit(low + theta, high + theta))
            or min(abs(theta - begin), abs(theta - end)) < 1e-9
        )


@settings(max_examples=examples(15))
@given(curves(), st.integers(2, 12))
def test_auto_xi_is_the_widest_even_one(curve: Curve, half: int) -> None:
    trace = along_axis(curve)
    xi = choose_xi(trace, 2 * half)
    chosen = fit_staircase(trace, xi, 2 * half)
    limit = xi_limit(*trace.heading_range())
    assert 0 < xi < limit
    if chosen.evenness >= MIN_EVENNESS:
        assert xi <= WIDEST_XI
        # No narrower angle on a grid is closer by more than the kink where "first" changes.
        for share in np.linspace(0.2, 0.95, 6):
            other = fit_staircase(trace, share * xi, 2 * half)
            assert other.distance >= chosen.distance * 0.98


def test_auto_theta_beats_a_grid_of_rotations() -> None:
    trace = trace_curve(graph("0.3*x + 0.2*sin(x)", 0, 5))
    xi = np.deg2rad(100)
    chosen = choose_theta(trace, 20, xi)

    def staircase(theta: float) -> Staircase:
        return fit_staircase(trace.rotated(theta), xi, 20)

    best = staircase(chosen)
    assert best.evenness >= MIN_EVENNESS - 1e-6
    low, high = theta_interval(*trace.heading_range(), xi)
    for theta in np.linspace(low, high, 23)[1:-1]:
        other = staircase(float(theta))
        assert other.evenness < MIN_EVENNESS or other.distance > 0.995 * best.distance


def test_auto_theta_leaves_a_symmetric_curve_alone() -> None:
    trace = trace_curve(graph("-x**2", -1, 1))
    assert choose_theta(trace, 10, np.deg2rad(50)) == 0.0
    assert choose_theta(trace, 10, None) == 0.0


def test_closeness_of_a_known_pair() -> None:
    # A chord of the unit circle's quarter: sagitta 1 - cos(pi/4); the chord's ends are on it.
    from strategies import pair

    trace = trace_curve(pair("cos(t)", "sin(t)", 0, np.pi / 2))
    closeness = measure_closeness(trace, np.array([[1.0, 0.0], [0.0, 1.0]]))
    assert closeness.max == pytest.approx(1 - np.cos(np.pi / 4), abs=1e-6)
    # rms: mean over the angle of (cos(u) - cos(pi/4))**2, u in [-pi/4, pi/4].
    c = np.cos(np.pi / 4)
    mean = (np.pi / 4 + 0.5 - 4 * c * c + c * c * np.pi / 2) / (np.pi / 2)
    assert closeness.rms == pytest.approx(np.sqrt(mean), rel=1e-5)


def test_searches_in_batches_find_what_each_finds_alone() -> None:
    trace = trace_curve(graph("0.3*x + 0.2*sin(x)", 0, 5))
    angles = (-0.2, 0.0, 0.15)

    def search(angle: float) -> Search[Staircase]:
        return rotated_search(search_staircase(trace.rotated(angle), 1.2, 10), angle)

    together = run_search(batched([search(angle) for angle in angles]), Nearest.to(trace))
    for found, angle in zip(together, angles, strict=True):
        alone = fit_staircase(trace.rotated(angle), 1.2, 10)
        assert found.distance == pytest.approx(alone.distance, rel=1e-12)
        np.testing.assert_allclose(found.lengths, alone.lengths, rtol=1e-9)


def test_a_rotation_is_chosen_with_few_questions() -> None:
    # Of 22 rotations 11 are looked at in a batch; asked one by one they took some 350 questions.
    trace = trace_curve(graph("-cosh(x)/2", -1.2, 0.9))
    asked = 0
    nearest = Nearest.__call__

    def counted(self: Nearest, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        nonlocal asked
        asked += 1
        return nearest(self, points)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Nearest, "__call__", counted)
        choose_theta(trace, 14, None)
    assert asked < 100
