"""What the family refuses, what it says, and that what it says works."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings

from orishell.conventions.errors import CurveError, DesignError
from orishell.curves import Curve, curve_from_points, trace_curve
from orishell.curves.nearest import Nearest
from samples import THOROUGH, led_by
from strategies import Request, graph, orthodiagonal, orthodiagonal_requests, pair

PARABOLA = graph("-x**2", -1, 1)
WAVE = graph("0.25*sin(pi*x/2)", 0, 4)
STRAIGHT = graph("0*x", 0, 4)


def request(f: Curve = PARABOLA, g: Curve = WAVE, **options: Any) -> Request:
    return orthodiagonal(f, g, **{"rows": 9, "columns": 13, "depth": 0.12, **options})


@settings(max_examples=100 if THOROUGH else 8)
@given(orthodiagonal_requests())
def test_candidates_mend_what_they_are_named_for(asked: Request) -> None:
    try:
        asked.design()
    except DesignError as error:
        for mended in asked.candidates(error):
            try:
                mended.design()
            except DesignError as other:  # another condition may fail, never the same one
                assert other.condition[:20] != error.condition[:20]  # noqa: PT017


@pytest.mark.parametrize("degrees", led_by([60, 130, 75, 110]))
def test_heading_outside_its_interval(degrees: float) -> None:
    what = request(heading_deg=degrees)
    error = what.refusal()
    assert "neighbouring rows meet" in error.condition
    assert error.place.startswith("between rows ")
    remedies = list(error.candidates)
    keys = {key for remedy in remedies for key in remedy.changes}
    assert keys == {"pattern.heading_deg", "target.g.scale", "pattern.depth"}
    for remedy in remedies:
        assert what.changed(remedy).design()
    # 0.5 % more than the largest scale does not work.
    scale = max(float(str(each.changes.get("target.g.scale", 0))) for each in remedies)
    request(heading_deg=degrees, g=WAVE.scaled(1.005 * scale)).refusal()


def test_interval_is_reported() -> None:
    design = request().design()
    interval = design.parameters["heading_interval_deg"]
    assert isinstance(interval, list)
    low, high = (float(degrees) for degrees in interval)
    assert 80 < low < 90 < high < 101
    for degrees in (low + 0.01, high - 0.01):
        assert request(heading_deg=degrees).design()
    bounds, alpha = (design.parameters[f"alpha_0{name}_deg"] for name in ("_interval", ""))
    assert isinstance(bounds, list)
    assert isinstance(alpha, float)
    assert float(bounds[0]) < alpha < float(bounds[1])


def test_auto_heading() -> None:
    assert request(heading_deg="auto").design().parameters["heading_deg"] == 90.0
    # g at 40 degrees to its own x axis: a right angle to its chord is at 50.
    g = curve_from_points(np.array([[0, 0], [3.0, 2.5]]), smooth=False)
    assert request(g=g).refusal()
    heading = request(g=g, heading_deg="auto").design().parameters["heading_deg"]
    assert heading == pytest.approx(90 - np.rad2deg(np.arctan2(2.5, 3)), abs=1)


def test_balanced_row_errs_on_both_sides_of_g() -> None:
    inscribed, balanced = (
        request(placement=placement).design() for placement in ("inscribed", "balanced")
    )
    assert balanced.parameters["placement"] == "balanced"
    assert 0.5 < balanced.closeness["g"].max / inscribed.closeness["g"].max < 0.6
    locked = balanced.mechanism.positions(np.pi)[5, 1:-1]
    _, off = Nearest.to(trace_curve(WAVE))(locked[:, :2])
    assert off.max() == pytest.approx(balanced.closeness["g"].max, rel=1e-3)
    np.testing.assert_allclose(locked[[0, -1]], [[0, 0, 0], [4, 0, 0]], atol=1e-12)


def test_plane_that_does_not_cross_g() -> None:
    what = request(g=graph("2*x", 0, 0.1), heading_deg=150)
    error = what.refusal()
    assert "does not cross" in error.condition
    assert "between columns" in error.place
    for mended in what.candidates(error):
        assert mended.design()


def test_g_that_turns_too_far() -> None:
    what = request(g=pair("cos(t)", "sin(t)", 0, 4), columns=30)
    error = what.refusal()
    assert "turns too far" in error.condition
    for mended in what.candidates(error):
        assert "turns too far" not in _condition(mended)


def test_depth_beyond_the_radius_of_curvature() -> None:
    what = request(depth=0.6)
    error = what.refusal()
    assert "that distance from f have cusps" in error.condition
    assert "0.5" in error.size
    mended = what.candidates(error)[0]
    assert 0.49 < mended.options["depth"] < 0.5
    assert mended.design()


def test_depth_too_small_to_alternate() -> None:
    what = request(depth=0.001, g=STRAIGHT)
    error = what.refusal()
    assert "too small" in error.condition
    assert "below 180" in error.size
    mended = what.candidates(error)[0]
    assert mended.options["depth"] > 0.001
    assert "turn left" not in _condition(mended)
    request(depth=0.98 * mended.options["depth"], g=STRAIGHT).refusal()


def test_depth_that_alternates_barely_is_mended_too() -> None:
    # Rows that hardly turn admit hardly any g: far greater depths must be looked at.
    f = curve_from_points([(0, 0), (1, 0), (2, 0.5), (2.5, 0), (3, 0)], smooth=False)
    what = request(f, graph("x**2", 0, 2), depth=0.0214, rows=17, columns=3, heading_deg="auto")
    mended = what.candidates(what.refusal())[0]
    assert "turn left" not in _condition(mended)
    assert mended.candidates(mended.refusal())[0].design()


def _condition(what: Request) -> str:
    try:
        what.design()
    except DesignError as error:
        return error.condition
    return ""


def test_too_few_rows_for_any_depth() -> None:
    f = graph("-20*x**4", -1, 1)
    what = request(f=f, g=STRAIGHT, rows=3, depth="auto")
    error = what.refusal()
    mended = what.candidates(error)[0]
    assert mended.options["rows"] > 3
    assert "alternately" not in _condition(mended)
    assert "offsets" not in _condition(mended)


def test_flaps_that_are_too_wide() -> None:
    what = request(flap=2.0)
    error = what.refusal()
    assert "flaps are too wide" in error.condition
    mended = what.candidates(error)[0]
    assert mended.design()
    request(flap=1.005 * mended.options["flap"]).refusal()
    assert request(flap="auto").design().parameters["flap"] < mended.options["flap"]


def test_panels_lost_in_rounding_are_refused() -> None:
    error = request(flap=1e-12).refusal()
    assert "rounding" in error.condition


def test_too_few_columns_are_said_aloud() -> None:
    g = graph("0.05*sin(10*x)", 0, 4)
    (warning,) = request(g=g, columns=5).design().warnings
    assert "5 columns leaves g by" in warning
    assert request(g=STRAIGHT, columns=2).design().warnings == ()


def test_unusable_curve_is_named() -> None:
    with pytest.raises(CurveError, match=r"^f at parameter"):
        request(f=graph("1/x", -1, 1)).design()
    with pytest.raises(CurveError, match=r"^g at parameter"):
        request(g=graph("1/x", -1, 1)).design()


def test_curves_may_run_either_way() -> None:
    one = request(f=graph("-x**2 + 0.2*x", -1, 1), g=graph("0.1*x**2", -1, 1), rows=5)
    other = request(f=pair("-t", "-t**2 - 0.2*t", -1, 1), g=pair("-t", "0.1*t**2", -1, 1), rows=5)
    np.testing.assert_allclose(
        one.design().mechanism.positions(1.0), other.design().mechanism.positions(1.0), atol=1e-6
    )


@pytest.mark.parametrize("heading", [np.pi / 2, 1.5])
def test_f_stands_upright_to_the_right_of_g(heading: float) -> None:
    f = graph("0.5*x + 0.2*sin(2*x)", 0, 3)
    design = request(f=f, heading_deg=np.rad2deg(heading), depth="auto").design()
    column = design.mechanism.positions(np.pi)[:, 1]
    t = np.array([np.cos(heading), -np.sin(heading)])
    end = f.position(3.0) - f.position(0.0)
    np.testing.assert_allclose(column[-1, :2] - column[0, :2], end[0] * t, atol=1e-12)
    assert column[-1, 2] - column[0, 2] == pytest.approx(end[1], abs=1e-12)
    # Target curves are where the locked shell meets them.
    locked = design.mechanism.positions(np.pi)
    np.testing.assert_allclose(design.targets["f"][[0, -1]], locked[[0, -1], 1], atol=1e-12)
    np.testing.assert_allclose(design.targets["g"][[0, -1]], locked[5, [1, -2]], atol=1e-12)


def test_ends_of_the_shell() -> None:
    # f meets the ground steeply: the shell stands on it.
    design = request().design()
    locked = design.mechanism.positions(np.pi)
    assert design.parameters["ends"] == ["level", "level"]
    assert np.ptp(locked[[0, -1], :, 2]) < 1e-12
    # A flat roof ends in planes square to it.
    design = request(f=graph("0.1*sin(x)", 0, 2), g=STRAIGHT, depth=0.1, flap=0.05).design()
    locked = design.mechanism.positions(np.pi)
    assert design.parameters["ends"] == ["square", "square"]
    chord = locked[-1, 1] - locked[0, 1]
    for row in (0, -1):
        across = (locked[row] - locked[row, 1]) @ np.array([0, chord[1], chord[2]])
        assert np.abs(across).max() < 1e-12
    # Where neither is within reason the end edges stay as they are.
    design = request(rows=99, columns=30, depth="auto", heading_deg="auto").design()
    assert design.parameters["ends"] == ["untrimmed", "untrimmed"]


def test_polyline_f_with_corners() -> None:
    f = curve_from_points(np.array([[-1, -1], [-0.5, 0.2], [0.4, 0.3], [1, -1.0]]), smooth=False)
    design = request(f=f, g=STRAIGHT, rows=15, depth="auto").design()
    assert design.closeness["f"].max < 0.3


@pytest.mark.parametrize(("rows", "columns"), [(1, 2), (1, 13), (9, 2), (3, 3)])
def test_smallest_sheets(rows: int, columns: int) -> None:
    design = request(
        g=graph("0.02*x**2", 0, 1), rows=rows, columns=columns, depth="auto", heading_deg="auto"
    ).design()
    assert design.mechanism.positions(1.0).shape == (rows + 2, columns + 2, 3)


@pytest.mark.parametrize(
    ("f", "g", "columns"),
    [
        (graph("x**3", -1, 1), graph("0.3*sin(x)", 0, 3), 13),
        (graph("-x**2", -0.3, 1), graph("0.1*x", 0, 2), 2),
        (PARABOLA, WAVE, 13),
    ],
)
def test_reported_interval_is_exact(f: Curve, g: Curve, columns: int) -> None:
    def at(degrees: float) -> Request:
        return request(f, g, columns=columns, heading_deg=degrees)

    interval = at(90).design().parameters["heading_interval_deg"]
    assert isinstance(interval, list)
    low, high = (float(degrees) for degrees in interval)
    for inside, outside in ((low + 1e-4, low - 1e-4), (high - 1e-4, high + 1e-4)):
        assert at(inside).design()
        at(outside).refusal()


def test_no_heading_is_offered_where_none_works() -> None:
    # f's plane crosses g at many headings, but rows meet at all of them: the crossing interval,
    # like the paper's condition, is only necessary.
    roof, bowl = graph("-abs(x)", -1, 1), graph("-sqrt(4-x**2)", -1.5, 1.5)
    error = request(roof, bowl, depth=0.1, heading_deg=np.rad2deg(np.pi)).refusal()
    first = next(iter(error.candidates))
    assert set(first.changes) == {"target.g.scale", "pattern.heading_deg"}
    assert request(roof, bowl, depth=0.1, heading_deg=np.rad2deg(np.pi)).changed(first).design()
    # Flaps of a given width may be too wide there.
    wide = request(roof, bowl, depth=0.1, heading_deg=np.rad2deg(np.pi), flap=0.5)
    assert next(iter(wide.refusal().candidates)).changes["pattern.flap"] == "auto"
    # Who wants no flaps is not offered any.
    bare = request(roof, bowl, depth=0.1, heading_deg=np.rad2deg(np.pi), flap=0)
    first = next(iter(bare.refusal().candidates))
    assert "pattern.flap" not in first.changes
    assert bare.changed(first).design().mechanism.grid.columns == 13
