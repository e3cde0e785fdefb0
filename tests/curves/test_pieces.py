"""Pieces are exact: against their formulas, against scipy's splines, under affine maps."""

from __future__ import annotations

from math import comb

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from orishell.conventions.errors import CurveError
from orishell.curves import Curve, curve_from_points, trace_curve
from orishell.curves.joining import join_pieces
from orishell.curves.pieces import (
    Affine,
    Arc,
    Piece,
    bezier,
    bulge_arc,
    circular_arc,
    nurbs,
    polyline,
)
from orishell.curves.piecewise import PieceArrays, curve_from_pieces

Array = NDArray[np.float64]
SHARES = np.linspace(0, 1, 101)


def sample(piece: Piece, shares: Array = SHARES) -> Array:
    arrays = PieceArrays.of([piece])
    return arrays.jet(np.zeros(len(shares), np.intp), shares)[0]


def curve_of(*pieces: Piece) -> Curve:
    """The curve through pieces that are already in order."""
    arrays = PieceArrays.of(pieces)
    joints = np.concatenate([arrays.at(0.0)[:1], arrays.at(1.0)])
    return curve_from_pieces(arrays, joints)


def numbers(low: float = -2.0, high: float = 2.0) -> st.SearchStrategy[float]:
    return st.floats(low, high, allow_nan=False).map(lambda x: round(x, 3))


POINTS = st.tuples(numbers(), numbers())
CUBIC = [(0, 0), (1, 2), (3, -1), (4, 1)]
ELLIPSE = Arc(np.array([0.3, 0.1]), np.array([[2.0, 0.5], [-0.3, 1.0]]), 0.4, -1.9)


def rational() -> list[Piece]:
    return nurbs(3, [0, 0, 0, 0, 1, 2.5, 2.5, 4, 4, 4, 4], *_control())


def _control() -> tuple[Array, Array]:
    x = np.arange(7)
    return np.stack([x + 0.2 * np.sin(3 * x), np.cos(2 * x)], axis=1), 1 + 0.3 * np.sin(5 * x)


@given(st.lists(POINTS, min_size=2, max_size=5))
def test_a_bezier_curve_is_its_bernstein_sum(points: list[tuple[float, float]]) -> None:
    control = np.array(points)
    degree = len(control) - 1
    steps = np.hypot(*np.diff(control, axis=0).T)
    if (steps < 1e-3).any():  # retracted control points have a test of their own
        return
    weight = [comb(degree, k) * SHARES**k * (1 - SHARES) ** (degree - k) for k in range(degree + 1)]
    # PieceArrays takes curves whose control points all lie in their ends for lines.
    inner = np.abs(control[1:-1, None] - control[[0, -1]]).max(axis=-1).min(initial=1.0)
    if inner < 1e-3:
        return
    # Powers of the share have coefficients of sum 3^degree at most, and every one is rounded where
    # it is made and where it is summed. Found: a fifth of that.
    rounding = 2 * (degree + 1) * 3**degree * np.finfo(float).eps * np.abs(control).max()
    np.testing.assert_allclose(
        sample(bezier(control)), np.stack(weight, axis=1) @ control, rtol=0, atol=rounding
    )


@pytest.mark.parametrize("bulge", [1.0, -1.0, 0.4142135623730951, -0.2, 3.0, 1e-3])
def test_a_bulge_is_an_arc_of_a_circle(bulge: float) -> None:
    """DXF: the bulge is the tangent of a quarter of the sweep, positive counter-clockwise."""
    start, end = np.array([0.5, -0.25]), np.array([2.0, 1.0])
    points = sample(bulge_arc(start, end, bulge))
    np.testing.assert_allclose(points[[0, -1]], [start, end], rtol=0, atol=2e-13)
    chord = end - start
    radius = np.hypot(*chord) * (1 + bulge**2) / (4 * abs(bulge))
    left = np.array([-chord[1], chord[0]]) / np.hypot(*chord)
    top = 0.5 * (start + end) - 0.5 * bulge * np.hypot(*chord) * left
    np.testing.assert_allclose(points[50], top, rtol=0, atol=2e-13)
    centre = top + np.sign(bulge) * radius * left
    np.testing.assert_allclose(np.hypot(*(points - centre).T) / radius, 1, rtol=0, atol=1e-12)


def test_a_flat_bulge_is_a_line() -> None:
    points = sample(bulge_arc([0, 0], [2, 0], 1e-12))
    np.testing.assert_array_equal(points[:, 1], 0)


def test_a_rational_quadratic_is_a_quarter_circle() -> None:
    """Weights 1, 1/sqrt(2), 1 (Piegl and Tiller, The NURBS Book, 7.2)."""
    pieces = nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], [1, np.sqrt(0.5), 1])
    assert len(pieces) == 1
    np.testing.assert_allclose(np.hypot(*sample(pieces[0]).T), 1, rtol=0, atol=1e-15)


@pytest.mark.parametrize("degree", [1, 2, 3, 5])
def test_nurbs_against_scipy(degree: int) -> None:
    from scipy.interpolate import BSpline

    rng = np.random.default_rng(degree)
    count = degree + 8
    inner = np.sort(rng.uniform(0, 5, count - degree - 1))
    inner[2] = inner[3]  # a double knot
    knots = np.concatenate([np.zeros(degree + 1), inner, np.full(degree + 1, 5.0)])
    control, weights = rng.normal(size=(count, 2)), rng.uniform(0.5, 2, count)
    if degree == 1:  # straight lines, which are run through at an even pace whatever their weights
        weights[:] = 1
    lifted = BSpline(knots, np.column_stack([control * weights[:, None], weights]), degree)
    spans = np.unique(knots)
    pieces = nurbs(degree, knots, control, weights)
    assert len(pieces) == len(spans) - 1
    for piece, low, high in zip(pieces, spans[:-1], spans[1:], strict=True):
        x, y, w = lifted(low + SHARES[:-1] * (high - low)).T
        expected = np.stack([x / w, y / w], axis=1)
        np.testing.assert_allclose(sample(piece)[:-1], expected, rtol=0, atol=1e-12)


def test_an_unclamped_spline_runs_between_its_inner_knots() -> None:
    from scipy.interpolate import BSpline

    knots, control = np.arange(9.0), _control()[0][:5]
    spline = BSpline(knots, control, 3)
    pieces = nurbs(3, knots, control)
    assert len(pieces) == 2
    np.testing.assert_allclose(sample(pieces[0])[0], spline(3.0), atol=1e-14)
    np.testing.assert_allclose(sample(pieces[1])[-1], spline(5.0), atol=1e-14)


@pytest.mark.parametrize(
    ("degree", "knots", "points", "weights", "says"),
    [
        (0, [0, 1], [(0, 0)], None, "degree"),
        (40, [0, 1], [(0, 0)], None, "degree"),
        (3, [0, 0, 1, 1], [(0, 0), (1, 1)], None, "too few control points"),
        (1, [0, 0, 1], [(0, 0), (1, 1)], None, "do not fit"),
        (1, [0, 1, 0, 1], [(0, 0), (1, 1)], None, "must not decrease"),
        (1, [0, np.nan, 1, 1], [(0, 0), (1, 1)], None, "must not decrease"),
        (1, [1, 1, 1, 1], [(0, 0), (1, 1)], None, "all the same"),
        (1, [0, 0, 1, 1], [(0, 0), (1, 1)], [1, 0], "positive"),
        (1, [0, 0, 1, 1], [(0, 0), (1, 1)], [1], "too few"),
    ],
)
def test_what_is_no_nurbs(
    degree: int,
    knots: list[float],
    points: list[tuple[float, float]],
    weights: list[float] | None,
    says: str,
) -> None:
    with pytest.raises(CurveError, match=says):
        nurbs(degree, knots, points, weights)


@pytest.mark.parametrize(
    "pieces",
    [
        polyline([(0, 0), (1, 1), (3, 0)]),
        [bezier(CUBIC[:3])],
        [bezier(CUBIC)],
        [ELLIPSE],
        [bulge_arc((0, 0), (1, 0), -0.3)],
        rational(),
        [bezier([(0, 0), (0, 0), (1, 1), (2, 0)])],
        [bezier([(0, 0), (1, 1), (2, 0), (2, 0)])],
        [*polyline([(-1, 0), (0, 0)]), bezier(CUBIC), circular_arc((4, 2), 1, -np.pi / 2, 2)],
    ],
)
def test_derivatives_are_those_of_the_position(pieces: list[Piece]) -> None:
    """Central differences over 1e-5 of the length, inside every piece."""
    curve = curve_of(*pieces)
    knots = np.array([curve.start, *curve.breaks, curve.stop])
    inside = (knots[:-1, None] + np.diff(knots)[:, None] * np.linspace(0.05, 0.95, 10)).ravel()
    step = 1e-5 * curve.stop
    low, here, high = (curve.jet(inside + shift) for shift in (-step, 0.0, step))
    np.testing.assert_allclose((high[0] - low[0]) / (2 * step), here[1], atol=2e-7)
    np.testing.assert_allclose((high[1] - low[1]) / (2 * step), here[2], atol=2e-5)


@given(st.lists(numbers(), min_size=6, max_size=6))
def test_affine_maps_of_pieces_are_exact(entries: list[float]) -> None:
    """The image of the piece is the piece of the image: a circle becomes an ellipse."""
    affine = Affine.of(*entries)
    for piece in (bezier(CUBIC), ELLIPSE, rational()[1]):
        mapped = sample(piece) @ affine.matrix + affine.offset
        arc = piece.transformed(affine)
        if isinstance(arc, Arc):
            np.testing.assert_allclose(sample(arc), mapped, atol=1e-13)
        else:
            control = arc.control[:, :2] / arc.control[:, 2:]
            if np.abs(np.linalg.det(affine.matrix)) > 1e-3:
                np.testing.assert_allclose(sample(arc), mapped, atol=1e-12)
            assert np.isfinite(control).all()


def test_maps_are_made_one_after_the_other() -> None:
    first, second = Affine.of(1, 2, 3, 4, 5, 6), Affine.of(0.5, -1, 2, 0, 1, 1)
    point = np.array([0.3, -0.7])
    once = point @ first.matrix + first.offset
    both = second.after(first)
    np.testing.assert_allclose(
        point @ both.matrix + both.offset, once @ second.matrix + second.offset, atol=1e-14
    )


@pytest.mark.parametrize(
    "piece", [bezier(CUBIC), ELLIPSE, rational()[0], bulge_arc((0, 0), (1, 0), 2)]
)
def test_reversed_pieces_have_the_same_points(piece: Piece) -> None:
    np.testing.assert_allclose(sample(piece.reversed()), sample(piece)[::-1], atol=1e-14)


RETRACTED = {
    "at the beginning": [(0, 0), (0, 0), (1, 1), (2, 0)],
    "at the end": [(0, 0), (1, 1), (2, 0), (2, 0)],
    "nearly, at the beginning": [(0, 0), (1e-8, 0), (1, 1), (2, 0)],
    "of a quadratic": [(0, 0), (0, 0), (2, 1)],
    "at both ends": [(0, 0), (0, 0), (2, 1), (2, 1)],
    "all of them": [(0, 0), (0, 0), (0, 0), (2, 1)],
}


@pytest.mark.parametrize("name", RETRACTED)
def test_retracted_handles_do_not_stand_still(name: str) -> None:
    """As drawing programs write nodes without a handle: the tangent there must not be zero."""
    control = np.array(RETRACTED[name], dtype=float)
    curve = curve_of(bezier(control))
    trace = trace_curve(curve)
    degree = len(control) - 1
    s = np.linspace(0, 1, 20001)
    weight = [comb(degree, k) * s**k * (1 - s) ** (degree - k) for k in range(degree + 1)]
    points = np.stack(weight, axis=1) @ control
    assert trace.length == pytest.approx(np.hypot(*np.diff(points, axis=0).T).sum(), rel=1e-6)
    from scipy.spatial import cKDTree

    assert np.max(cKDTree(points).query(trace.points)[0]) < 2e-4  # the samples' spacing
    middle = np.array([curve.start, curve.stop])
    assert np.isfinite(curve.jet(middle)[2]).all()


def test_smooth_joints_are_no_corners_and_lose_no_length() -> None:
    """A line into an arc of radius 1/2 into a line: the curvature jumps, the tangent does not."""
    curve = curve_of(
        *polyline([(-1, 0), (0, 0)]),
        circular_arc((0, 0.5), 0.5, -np.pi / 2, np.pi / 2),
        *polyline([(0.5, 0.5), (0.5, 1.3)]),
    )
    trace = trace_curve(curve)
    assert len(curve.breaks) == 2
    assert len(trace.corners) == 0
    assert trace.length == pytest.approx(1.8 + np.pi / 4, rel=1e-13)
    np.testing.assert_allclose(curve.curvature(np.array([0.5, 1.2, 2.0])), [0, 2, 0], atol=1e-12)


def test_corners_are_kept() -> None:
    trace = trace_curve(curve_of(*polyline([(0, 0), (1, 0), (2, 1), (3, 1)])))
    np.testing.assert_allclose(trace.points[trace.corners], [(1, 0), (2, 1)], atol=1e-15)


def test_slow_pieces_are_followed_to_their_middle() -> None:
    """Thousands of cubics with short handles: each is one cell of the trace, slow at both ends."""
    x = np.linspace(0, 10, 2001)
    points = np.stack([x, np.sin(x)], axis=1)
    slope = np.stack([np.ones_like(x), np.cos(x)], axis=1) * 1e-4
    cubics = [
        bezier([p, p + 0.005 * d, q - 0.005 * e, q])
        for p, q, d, e in zip(points[:-1], points[1:], slope[:-1], slope[1:], strict=True)
    ]
    trace = trace_curve(curve_of(*cubics))
    assert trace.length == pytest.approx(np.hypot(*np.diff(points, axis=0).T).sum(), rel=1e-3)


def test_thousands_of_lines() -> None:
    x = np.linspace(0, 10, 20_001)
    points = np.stack([x, np.sin(x)], axis=1)
    chain = join_pieces(polyline(points), str)
    assert len(chain.pieces) == 20_000
    np.testing.assert_allclose(chain.joints, points, rtol=0, atol=1e-15)
    curve = chain.curve()
    knots = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    np.testing.assert_allclose(curve.position(knots), points, rtol=0, atol=1e-12)


def test_a_reversed_polyline_leaves_its_corners_by_the_later_side() -> None:
    """What ``Curve.breaks`` promises, for curves that are reversed after they were made."""
    points = np.array([(0.1, 0), (1.3, 0), (2.7, 1.1), (3.9, 1.2)])
    curve = curve_from_points(points, smooth=False).reversed()
    straight = curve_from_points(points[::-1], smooth=False)
    for shift in (0.0, -np.inf):  # at the breaks, and just before them
        mine, theirs = (
            np.nextafter(each.breaks, shift) if shift else np.array(each.breaks)
            for each in (curve, straight)
        )
        np.testing.assert_allclose(curve.tangent(mine), straight.tangent(theirs), atol=1e-12)
    t = np.linspace(0, curve.stop, 501)
    np.testing.assert_allclose(curve.position(t), straight.position(t), atol=1e-14)
