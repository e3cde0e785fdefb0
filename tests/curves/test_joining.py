"""Pieces in any order and direction make the same curve; or the message says where they do not."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from orishell.conventions.errors import CurveError
from orishell.curves import curve_from_points, trace_curve
from orishell.curves.joining import TOLERANCE, join_pieces
from orishell.curves.pieces import Piece, bezier, bulge_arc, circular_arc, nurbs, polyline

Array = NDArray[np.float64]


def place(point: Array) -> str:
    return f"({point[0]:g}, {point[1]:g}) mm"


PIECES: list[Piece] = [
    *polyline([(0, 0), (1, 0.5)]),
    bezier([(1, 0.5), (1.5, 1), (2, -1), (3, 0)]),
    bulge_arc((3, 0), (4, 1), 0.5),
    bezier([(4, 1), (5, 2), (6, 1)]),
    *nurbs(2, [0, 0, 0, 1, 2, 2, 2], [(6, 1), (6.5, 0.5), (7, 1), (7.5, 3)], [1, 2, 1, 1]),
    *polyline([(7.5, 3), (8, 0), (8.5, 0.25)]),
]


@given(st.permutations(range(len(PIECES))), st.lists(st.booleans(), min_size=8, max_size=8))
def test_order_and_direction_do_not_matter(order: list[int], turned: list[bool]) -> None:
    shuffled = [
        PIECES[k].reversed() if back else PIECES[k] for k, back in zip(order, turned, strict=True)
    ]
    curve, straight = join_pieces(shuffled, place).curve(), join_pieces(PIECES, place).curve()
    np.testing.assert_allclose(curve.breaks, straight.breaks, rtol=1e-12)
    t = np.linspace(0, straight.stop, 200)[1:-1]
    for mine, theirs in zip(curve.jet(t), straight.jet(t), strict=True):
        np.testing.assert_allclose(mine, theirs, rtol=1e-10, atol=1e-10)
    np.testing.assert_array_equal(curve.position(0.0), [0, 0])


def test_the_curve_begins_at_the_left_and_if_upright_at_the_bottom() -> None:
    assert join_pieces(polyline([(3, 1), (1, 0)]), place).joints[0].tolist() == [1, 0]
    assert join_pieces(polyline([(1, 5), (2, 3), (1, 0)]), place).joints[0].tolist() == [1, 0]
    # Ends are at the same x if they differ by less than the tolerance.
    tilted = polyline([(1 - 1e-7, 5), (1, 0)])
    assert join_pieces(tilted, place).joints[0].tolist() == [1, 0]


def test_ends_within_the_tolerance_are_joined_and_meet_exactly() -> None:
    """The tolerance is 1e-6 of the diagonal, here 10: ends 5e-6 apart meet halfway."""
    pieces = polyline([(0, 0), (4, 0)]) + polyline([(4, 5e-6), (10, 0)])
    chain = join_pieces(pieces, place)
    np.testing.assert_allclose(chain.joints[1], [4, 2.5e-6], rtol=1e-12)
    curve = chain.curve()
    before = curve.position(np.nextafter(curve.breaks[0], 0))
    np.testing.assert_allclose(before, curve.position(curve.breaks[0]), rtol=0, atol=1e-14)
    with pytest.raises(CurveError, match="gaps"):
        join_pieces(polyline([(0, 0), (4, 0)]) + polyline([(4, 5e-5), (10, 0)]), place)
    assert TOLERANCE == 1e-6


def test_an_arc_stays_where_it_is_if_its_ends_fit() -> None:
    arc = circular_arc((0, 0), 1, 0, 1)
    curve = join_pieces([arc, *polyline([(1, -1), (1, 0)])], place).curve()
    points = curve.position(np.linspace(0, 0.999, 50))
    np.testing.assert_allclose(np.hypot(*points.T), 1, rtol=0, atol=1e-15)


def test_duplicates_and_points_are_dropped() -> None:
    line, arc = polyline([(0, 0), (1, 0)])[0], bulge_arc((1, 0), (2, 0), 1)
    dot = polyline([(1, 0), (1, 0)])[0]
    chain = join_pieces([arc, line, dot, line.reversed(), arc, arc.reversed(), dot], place)
    np.testing.assert_allclose(chain.joints, [(0, 0), (1, 0), (2, 0)], atol=1e-15)
    # Two ways from one point to another are no duplicates: the curve is closed.
    with pytest.raises(CurveError, match="closed"):
        join_pieces([arc, bulge_arc((1, 0), (2, 0), -1)], place)


@pytest.mark.parametrize(
    ("pieces", "says"),
    [
        ([], ["nothing is drawn"]),
        (polyline([(1, 2), (1, 2)]), ["single point", "(1, 2) mm"]),
        ([circular_arc((0, 0), 1, 0, 2 * np.pi)], ["closed", "from (1, 0) mm"]),
        (polyline([(0, 0), (1, 0), (1, 1), (0, 0)]), ["closed", "from (0, 0) mm"]),
        (
            polyline([(0, 0), (1, 0), (1, 1), (0, 0)]) + polyline([(5, 5), (6, 6)]),
            ["closed", "from (0, 0) mm"],
        ),
        (
            polyline([(0, 0), (1, 0), (2, 0)]) + polyline([(1, 0), (1, 3)]),
            ["branches", "at (1, 0) mm", "3 ends"],
        ),
        (
            polyline([(0, 0), (1, 0)]) + polyline([(1.25, 0), (2, 0)]) + polyline([(4, 0), (5, 0)]),
            ["gaps", "between (1, 0) mm and (1.25, 0) mm", "3 separate parts", "0.25 apart"],
        ),
        (polyline([(0, 0), (np.nan, 1)]), ["not finite"]),
        (polyline([(0, 0), (1e200, 1)]), ["not finite, or too large"]),
        (polyline(np.stack([np.arange(50_002)] * 2, axis=1)), ["too many pieces"]),
    ],
)
def test_errors_say_where(pieces: list[Piece], says: list[str]) -> None:
    with pytest.raises(CurveError) as caught:
        join_pieces(pieces, place)
    for text in says:
        assert text in str(caught.value)


def test_thousands_of_coinciding_pieces_take_no_quadratic_memory() -> None:
    line = polyline([(0, 0), (1, 0)])[0]
    assert len(join_pieces([line] * 30_000, place).pieces) == 1


def test_a_spline_smooths_many_short_segments() -> None:
    """Of a circle drawn as chords of 3 degrees the spline is 1000 times nearer to it."""
    angle = np.deg2rad(np.arange(150, 29, -3))
    chain = join_pieces(polyline(np.stack([np.cos(angle), np.sin(angle)], axis=1)), place)
    trace = trace_curve(chain.spline())
    drawn = trace_curve(chain.curve())
    assert len(trace.corners) == 0
    assert len(drawn.corners) == 39
    errors = [np.abs(np.hypot(*each.points.T) - 1).max() for each in (drawn, trace)]
    assert errors[0] == pytest.approx(1 - np.cos(np.deg2rad(1.5)), rel=1e-6)
    assert errors[1] < 1e-3 * errors[0]


def test_a_spline_takes_enough_points_of_bent_pieces() -> None:
    chain = join_pieces([circular_arc((0, 0), 1, 0, np.pi)], place)
    trace = trace_curve(chain.spline())
    assert np.abs(np.hypot(*trace.points.T) - 1).max() < 1e-5  # a share of 0.1 rad to the fourth
    cubic = bezier([(0, 0), (1, 2), (2, -2), (3, 0)])
    spline, exact = join_pieces([cubic], place).spline(), join_pieces([cubic], place).curve()
    assert trace_curve(spline).length == pytest.approx(trace_curve(exact).length, rel=1e-5)


@pytest.mark.parametrize("unit", [1e-20, 1e20])
def test_a_spline_does_not_mind_the_unit(unit: float) -> None:
    points = np.array([(0, 0), (1, 1), (2.5, 0.5)])
    here, there = (
        curve_from_points(points, smooth=True),
        curve_from_points(points * unit, smooth=True),
    )
    t = np.linspace(0, here.stop, 20)
    for order, (mine, theirs) in enumerate(zip(there.jet(t * unit), here.jet(t), strict=True)):
        np.testing.assert_allclose(mine * unit ** (order - 1), theirs, rtol=1e-9, atol=1e-12)


def test_points_that_coincide_beside_the_length_of_the_curve() -> None:
    """Chords that vanish when they are added to the length before them."""
    zigzag = np.stack([np.arange(20_002) % 2, np.zeros(20_002)], axis=1)
    near = zigzag[-1] + np.array([2e-12, 0])
    points = np.concatenate([zigzag, [near, (3, 3)]])
    with pytest.raises(CurveError, match="points 20002 and 20003: two successive points coincide"):
        curve_from_points(points, smooth=True)
