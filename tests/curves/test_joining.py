"""Pieces in any order and direction make the same curve; or the message says where they do not."""

from __future__ import annotations

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from orishell.conventions.errors import CurveError
from orishell.curves import curve_from_points, trace_curve
from orishell.curves.joining import SAME_END, join_pieces
from orishell.curves.pieces import Affine, Piece, bezier, bulge_arc, circular_arc, nurbs, polyline

Array = NDArray[np.float64]


def place(point: Array) -> str:
    return f"({point[0]:.15g}, {point[1]:.15g}) mm"


def told(text: str) -> Array:
    """Points (N, 2) that a message names."""
    return np.array(re.findall(r"\((-?[\d.e-]+), (-?[\d.e-]+)\)", text), dtype=np.float64)


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
    assert chain.notes == ()
    apart = join_pieces(polyline([(0, 0), (4, 0)]) + polyline([(4, 5e-5), (10, 0)]), place)
    np.testing.assert_allclose(apart.joints[1], [4, 2.5e-5], rtol=1e-12)
    assert apart.notes != ()
    assert SAME_END == 1e-6


def torn(rng: np.random.Generator, gaps: Array) -> tuple[list[Piece], Array]:
    """An arc of radius 10 in pieces, in any order and direction, with gaps between them; its ends.

    The pieces are straight or bent, 0.5 long at least.
    """
    count = len(gaps) + 1
    angle = np.pi - np.cumsum(np.append(0.0, rng.uniform(0.05, 0.1, count)))
    corners = 10 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    turn = rng.uniform(0, 2 * np.pi, len(gaps))
    half = 0.5 * gaps[:, None] * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    begins, ends = corners[:-1].copy(), corners[1:].copy()
    ends[:-1] -= half
    begins[1:] += half
    pieces: list[Piece] = [
        polyline([begin, end])[0]
        if rng.integers(2)
        else bezier([begin, 0.5 * (begin + end) + 0.1 * rng.normal(size=2), end])
        for begin, end in zip(begins, ends, strict=True)
    ]
    pieces = [each.reversed() if rng.integers(2) else each for each in pieces]
    return [pieces[k] for k in rng.permutation(count)], np.array([begins[0], ends[-1]])


@pytest.mark.parametrize("seed", range(20))
def test_the_smallest_gaps_are_joined_by_themselves_and_it_is_said(seed: int) -> None:
    """Gaps of 1e-5 to 3e-3 of what is about 10 wide, some of them 0; pieces are 0.5 long."""
    rng = np.random.default_rng(seed)
    gaps = 10 ** rng.uniform(-4, -1.5, 12) * rng.integers(0, 2, 12)
    gaps[rng.integers(12)] = 10 ** rng.uniform(-4, -1.5)
    pieces, ends = torn(rng, gaps)
    chain = join_pieces(pieces, place, unit="mm")
    assert len(chain.pieces) == 13
    np.testing.assert_allclose(chain.joints[[0, -1]], ends, rtol=0, atol=1e-12)
    (note,) = chain.notes
    assert float(note.split()[3]) == pytest.approx(gaps.max(), rel=0.051)  # two digits
    assert note == f"ends up to {note.split()[3]} mm apart were joined"
    for same in (chain.reversed(), chain.scaled(2.0)):
        assert same.notes == same.curve().notes == same.spline().notes == chain.notes
    np.testing.assert_array_equal(
        join_pieces(pieces, place, join=1.01 * gaps.max()).joints, chain.joints
    )


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize("why", ["it is wide", "another end is near"])
def test_what_may_be_meant_is_not_joined_unasked_but_as_the_message_says(
    seed: int, why: str
) -> None:
    rng = np.random.default_rng(seed)
    wide = why == "it is wide"
    gaps = np.zeros(12)
    gaps[rng.integers(12)] = rng.uniform(0.06, 0.1) if wide else 0.01
    pieces, ends = torn(rng, gaps)
    if not wide:  # a piece that is three gaps long, a gap from the end
        pieces += polyline(ends[1] + np.array([[0.01, 0], [0.04, 0]]))
    with pytest.raises(CurveError, match="gaps") as caught:
        join_pieces(pieces, place)
    error = caught.value
    assert error.remedy.startswith("join = ")
    join = float(error.remedy.split()[2])
    assert error.changes == {"join": join}
    chain = join_pieces(pieces, place, join)
    assert len(chain.pieces) == len(pieces)
    assert gaps.max() < join < 1.3 * gaps.max()
    assert len(chain.notes) == 1


@pytest.mark.parametrize("offset", [0.0, 5e6])
@pytest.mark.parametrize("gap", [0.3, 2.4e-3, 1.7e-4])
def test_ends_are_named_in_digits_that_tell_them_apart(gap: float, offset: float) -> None:
    """Also where coordinates are those of a map: by the gap, not by the size of the numbers."""
    pieces = polyline([(0, 0), (1 / 3, 1 / 7)]) + polyline([(1 / 3 + gap, 1 / 7), (1.7, 1.7)])
    # A third piece beside both leaves it open which ends are one.
    pieces += polyline([(1 / 3 + 0.5 * gap, 1 / 7 + gap), (0, 1.7)])
    moved = [each.transformed(Affine.of(1, 0, 0, 1, offset, offset)) for each in pieces]
    with pytest.raises(CurveError, match="gaps") as caught:
        join_pieces(moved, place)
    first, second = told(caught.value.where)
    assert np.hypot(*(second - first)) == pytest.approx(gap, rel=0.06, abs=1e-8)


def test_too_wide_a_gap_is_left_to_who_drew_it() -> None:
    with pytest.raises(CurveError, match="gaps") as caught:
        join_pieces(polyline([(0, 0), (4, 0)]) + polyline([(4.3, 0), (10, 0)]), place)
    assert caught.value.remedy == "make ends meet, or choose its pieces"
    assert caught.value.changes == {}


def test_the_ends_of_the_curve_itself_are_not_joined() -> None:
    """A horseshoe stays one, however near its ends are."""
    horseshoe = [circular_arc((0, 0), 1, 0.01, 2 * np.pi - 0.02)]
    assert len(join_pieces(horseshoe, place, join=0.1).pieces) == 1
    halves = polyline([(0, 0), (1, 1)]) + polyline([(1.001, 1), (0.001, 0.001)])
    with pytest.raises(CurveError, match="closed"):
        join_pieces(halves, place, join=0.01)
    with pytest.raises(CurveError, match="gaps"):  # unasked both may not be meant
        join_pieces(halves, place)


@pytest.mark.parametrize("seed", range(10))
def test_a_closed_curve_names_the_straight_line_that_opens_it(seed: int) -> None:
    """An arch on its baseline, as one draws it to be filled."""
    rng = np.random.default_rng(seed)
    pieces, (first, last) = torn(rng, np.zeros(20))
    baseline = polyline([last, first])
    with pytest.raises(CurveError, match="closed") as caught:
        join_pieces(pieces + baseline, place)
    assert "as the straight line from" in caught.value.remedy
    np.testing.assert_allclose(told(caught.value.remedy), [last, first], atol=1e-4)
    assert len(join_pieces(pieces, place).pieces) == 21
    with pytest.raises(CurveError, match="closed") as caught:
        join_pieces([*pieces, *baseline, *polyline([(20, 0), (21, 1)])], place)
    assert caught.value.remedy == "choose its pieces"


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
    assert caught.value.remedy


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
