"""What curves do between their samples: bounds hold, and nothing that matters is missed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.conventions.errors import CurveError
from orishell.curves import Curve, curve_from_points, parse_formula, trace, trace_curve
from orishell.curves.joining import join_pieces
from orishell.curves.pieces import Arc, Bezier, Piece, bezier, circular_arc
from orishell.curves.sample_gaps import NEAR
from orishell.curves.trace import FIRST_CELLS, MAX_TURN
from samples import examples
from strategies import curves, graph, pair

Array = np.ndarray
SHARES = np.linspace(0, 1, 41)

FORMULAS = [
    "sin(3*x) - cos(2*x)",
    "tan(x/2) + atan(5*x)",
    "asin(x/3) * acos(x/4)",
    "sinh(x) - cosh(x/2)*tanh(4*x)",
    "exp(-x**2) / log(4 + x)",
    "sqrt(3 + x) * abs(x - 0.5)",
    "x**3 - x**2 + 2**x",
    "(x + 3.5)**-1.5 + (x + 3.5)**0.5",
    "abs(x)**1.5 + sqrt(x**2)",
    "1/(x**2 + 0.01) - x**-2",
    "e**(1/x)",
    "7",
]


def require_inside(curve: Curve, low: Array, high: Array) -> None:
    """Values and derivatives at points of each range lie in its boxes, but for rounding."""
    boxes = curve.enclosure(low, high)
    inner = low + (high - low) * SHARES[1:-1, None]
    jets = curve.jet(inner)
    for axis, box in enumerate(boxes):
        for values, bounds in zip(jets, (box.value, box.first, box.second), strict=True):
            found = values[..., axis]
            allowed = 1e-9 * (1 + np.abs(found).max(axis=0))
            # Where nothing is known, ends are not numbers.
            assert not (found < bounds.low - allowed).any()
            assert not (found > bounds.high + allowed).any()


@pytest.mark.parametrize("text", FORMULAS)
@given(start=st.floats(-2.9, 2.5), width=st.sampled_from([1e-6, 1e-3, 0.05, 0.4]))
def test_formulas_are_enclosed(text: str, start: float, width: float) -> None:
    curve = graph(text, -3, 3)
    with np.errstate(all="ignore"):
        require_inside(curve, np.array([start]), np.array([start + width]))


@pytest.mark.parametrize("text", FORMULAS[:7])
def test_bounds_close_in_as_ranges_shrink(text: str) -> None:
    """Twice as narrow a range has bounds twice as narrow, so that bisecting comes to an end."""
    low = np.linspace(0.6, 2, 30)
    widths = []
    for width in (2e-4, 1e-4):
        found = parse_formula(text).enclosure(low, low + width)
        widths.append([each.high - each.low for each in (found.value, found.first, found.second)])
    np.testing.assert_allclose(np.divide(widths[0], widths[1]), 2, rtol=0.02)


def test_what_is_not_defined_is_not_bounded() -> None:
    for text in ("1/x", "log(x)", "sqrt(x)", "tan(x + pi/2)", "asin(1 + x)", "x**-2", "x**0.5"):
        found = parse_formula(text).enclosure(np.array([-1e-9]), np.array([1e-9])).value
        assert not np.isfinite([found.low, found.high]).all(), text


MEETING = 2 * np.array([np.cos(np.pi - 1.2), np.sin(np.pi - 1.2)])
DRAWINGS: dict[str, list[Piece]] = {
    "lines, cubic, quintic": [
        bezier([[0.0, 0.0], [1.0, 0.2]]),
        bezier([[1.0, 0.2], [2.0, 1.0], [3.0, -1.0], [4.0, 0.0]]),
        bezier([[4.0, 0.0], [5.0, 0.0], [5.0, 0.3], [5.5, 0.3], [6.0, 0.0], [7.0, 0.0]]),
    ],
    "retracted at either end": [
        bezier([[0, 0], [0, 0], [1, 1], [2, 0]]),
        bezier([[2, 0], [3, -1], [4, 0], [4, 0]]),
    ],
    "rational": [Bezier(np.array([[0, 0, 1], [3.0, 6.0, 3.0], [2, 0, 0.5]]))],
    "arcs": [
        circular_arc([0, 0], 2.0, np.pi, -1.2),
        Arc(MEETING + np.array([3, 0]), np.array([[3.0, 0], [0.5, 1]]), np.pi, -1.5),
    ],
}


def drawing(name: str) -> Curve:
    return join_pieces(DRAWINGS[name], str).curve()


def variants(curve: Curve) -> list[Curve]:
    return [curve, curve.reversed(), curve.scaled(2.5), curve.rotated(0.7).reversed()]


@pytest.mark.parametrize("name", DRAWINGS)
def test_drawings_are_enclosed(name: str) -> None:
    for curve in variants(drawing(name)):
        for count in (40, 3000):
            t = np.union1d(np.linspace(curve.start, curve.stop, count), curve.breaks)
            require_inside(curve, t[:-1], t[1:])


@given(curves())
def test_curves_are_enclosed(curve: Curve) -> None:
    for each in variants(curve):
        t = np.union1d(np.linspace(each.start, each.stop, 50), each.breaks)
        require_inside(each, t[:-1], t[1:])


def sampled_alone(curve: Curve) -> trace.Trace:
    """The trace as samples alone would have it."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(trace, "missing_samples", lambda *_: np.zeros(0))
        return trace.trace_curve(replace(curve))  # another one: traces are kept


@given(curves())
def test_ordinary_curves_need_no_more_samples(curve: Curve) -> None:
    np.testing.assert_array_equal(trace_curve(curve).t, sampled_alone(curve).t)


@pytest.mark.parametrize("name", DRAWINGS)
def test_ordinary_drawings_need_no_more_samples(name: str) -> None:
    curve = drawing(name)
    np.testing.assert_array_equal(trace_curve(curve).t, sampled_alone(curve).t)


def farthest(curve: Curve, followed: trace.Trace, t: Array) -> float:
    """The largest distance from the chords, relative to what is stated of them.

    The tangent stays within 2 MAX_TURN of where a cell starts: a curve leaves its chord by half of
    the chord times the tangent of that, at most.
    """
    k = np.clip(np.searchsorted(followed.t, t, side="right") - 1, 0, len(followed.t) - 2)
    start = followed.points[k]
    chord = followed.points[k + 1] - start
    length = np.hypot(*chord.T)
    unit = chord / length[:, None]
    away = curve.position(t) - start
    along = np.clip((away * unit).sum(axis=1), 0, length)
    distance = np.hypot(*(away - along[:, None] * unit).T)
    stated = 0.5 * np.tan(2 * MAX_TURN) * length + NEAR * followed.length
    return float((distance / stated).max())


FEATURES: dict[str, Callable[[float, float, float], str]] = {
    "bump": lambda c, w, a: f"{a!r}*exp(-((x - {c!r})/{w!r})**2)",
    "step": lambda c, w, a: f"{a!r}*tanh((x - {c!r})/{w!r})",
    "waves": lambda c, w, a: f"{a!r}*sin((x - {c!r})/{w / 7!r})*exp(-((x - {c!r})/{w!r})**2)",
    "kink": lambda c, w, a: f"{a!r}*abs((x - {c!r})/{w!r})/(1 + ((x - {c!r})/{w!r})**2)",
    "ripple": lambda c, w, a: f"{1e-4 * a * w!r}*sin(x/{w!r})",
    "gap": lambda c, w, a: f"{a!r}*sqrt((x - {c!r})**2 - {w * w!r})",
    "pole": lambda c, w, a: f"{a * w!r}/(x - {c!r})",
}
REFUSED = {"gap", "pole"}
"""They have no value somewhere."""


@pytest.mark.parametrize("feature", FEATURES)
@settings(max_examples=examples(40))
@given(
    base=st.sampled_from(["0*x", "x**2/3", "cosh(x)", "0.3*sin(2*x)"]),
    place=st.floats(0.02, 0.98),
    width=st.floats(-10, -2).map(lambda power: 10.0**power),
    size=st.floats(-12, 0).map(lambda power: 10.0**power),
)
def test_a_hidden_feature_is_followed_or_refused(
    feature: str, base: str, place: float, width: float, size: float
) -> None:
    curve = graph(f"{base} + {FEATURES[feature](place, width, size)}", 0, 1)
    try:
        followed = trace_curve(curve)
    except CurveError:
        # What is wide and no spike can be followed.
        assert feature in REFUSED or width < 1e-4 or size > width
        return
    assert feature not in REFUSED
    near = np.concatenate([np.linspace(-12, 12, 20_001), *np.logspace(-6, 8, 800) * [[-1], [1]]])
    t = np.concatenate([np.linspace(0, 1, 5001), np.clip(place + width * near, 0, 1)])
    assert farthest(curve, followed, t) <= 1


@pytest.mark.parametrize(
    ("text", "height"),
    [("exp(-1e10*(x-0.31415926)**2)", 1.0), ("1e-3/(1 + 1e14*(x - 0.7182818)**2)", 1e-3)],
)
def test_a_spike_between_samples_is_followed(text: str, height: float) -> None:
    curve = graph(text, 0, 1)
    assert sampled_alone(curve).bounding_box()[1][1] < 0.01 * height
    assert trace_curve(curve).bounding_box()[1][1] == pytest.approx(height, abs=NEAR * 3)


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("1e-12/(x-0.31415926)", "0.314159"),
        ("1e-30*(x - 0.31415926)**-2", "0.31415926"),
        ("x + 1e-15*log(abs(x - 0.31415926))", "0.31415926"),
        ("sqrt((x - 0.31415926)**2 - 1e-26)", "0.31415926"),
        ("1e-7*abs(x - 0.31415926)/(x - 0.31415926)", "0.314159"),
        ("sin(x - 0.31415926)/(x - 0.31415926)", "0.31"),
    ],
)
def test_what_has_no_bounds_is_refused_with_its_place(text: str, place: str) -> None:
    sampled_alone(graph(text, 0, 1))
    with pytest.raises(CurveError, match=f"at parameter {place}"):
        trace_curve(graph(text, 0, 1))


def test_a_narrow_bulge_of_points_or_a_drawing_is_followed() -> None:
    """Siblings of narrow features of formulas: between two of the first samples, all the same."""
    cell = 10 / FIRST_CELLS
    # Points so many that the bump of one dies away among them, between two samples.
    x = np.concatenate([[0, 2], 3 + cell * np.linspace(0.3, 0.7, 41), [6, 10]])
    y = np.where(np.arange(len(x)) == 22, 0.05 * cell, 0.0)
    spline = curve_from_points(np.stack([x, y], axis=-1), smooth=True)
    # A short piece whose ends run along its chord, between long ones.
    bulge = np.array([[0, 0], [1, 0], [2, 4], [3, 4], [4, 0], [5, 0]]) * 1e-3 + [5.002, 0]
    lines = [bezier([[0.0, 0.0], bulge[0]]), bezier([bulge[-1], [10.0, 0.0]])]
    drawn = join_pieces([*lines, bezier(bulge)], str)
    for curve in (spline, drawn.curve()):
        t = np.linspace(curve.start, curve.stop, 400_001)
        assert farthest(curve, sampled_alone(curve), t) > 5
        assert farthest(curve, trace_curve(curve), t) <= 1


def test_a_pair_is_bounded_in_both_coordinates() -> None:
    loop = pair("t + 1e-3*exp(-1e12*(t - 0.2345678)**2)", "t**2", 0, 1)
    t = np.linspace(0.2345, 0.2346, 100_001)
    assert farthest(loop, sampled_alone(loop), t) > 50
    assert farthest(loop, trace_curve(loop), t) <= 1
