"""What the family refuses, what it says, and that what it says works."""

import re
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import CurveError, DesignError, InputError, Remedy
from orishell.curves import Curve, curve_from_points, trace_curve
from orishell.curves.nearest import Nearest
from orishell.families.parallel_repeating import ParallelRepeating
from strategies import Request, graph, pair, parallel_repeating

PARABOLA = graph("-x**2", -1, 1)
WAVE = graph("5*sin(pi*x/10)", 0, 20)
STRAIGHT = graph("0*x", 0, 20)


def request(f: Curve = PARABOLA, g: Curve = WAVE, **options: Any) -> Request:
    asked = {"rows": 9, "columns": 11, "xi_deg": 50, "flap": 0.3, **options}
    return parallel_repeating(f, g, **asked)


def of_key(error: DesignError, key: str) -> list[Any]:
    """Values that a refusal's candidates have at a key."""
    return [each.changes[key] for each in error.candidates if key in each.changes]


def test_figure_1_needs_no_mending() -> None:
    design = request().design()
    assert design.warnings == ()
    assert design.parameters["xi_deg"] == 50.0
    assert design.parameters["xi_limit_deg"] == pytest.approx(53.1301, abs=1e-4)


def test_too_large_xi_names_the_limit() -> None:
    error = request(xi_deg=60).refusal()
    assert "below 53.1301" in error.size
    assert "xi_deg = 60 is too large" in error.condition
    what = request(xi_deg=60)
    values = of_key(error, "pattern.xi_deg")
    assert values == sorted(values, reverse=True)
    assert 53 < values[0] < 53.1301
    for degrees in values:
        assert what.changed(Remedy({"pattern.xi_deg": degrees})).design()


def test_too_large_xi_offers_the_rotations_that_work() -> None:
    what = request(f=graph("exp(x)", -2, 1), g=STRAIGHT, xi_deg=60)
    error = what.refusal()
    for degrees in of_key(error, "pattern.theta_deg"):
        assert what.changed(Remedy({"pattern.theta_deg": degrees})).design()


def test_rotation_that_admits_no_xi() -> None:
    what = request(f=graph("exp(x)", -2, 1), g=STRAIGHT, xi_deg="auto", theta_deg=40)
    error = what.refusal()
    assert "no staircase for theta_deg = 40" in error.condition
    assert what.improved(error).design()


def test_f_that_turns_too_much() -> None:
    circle = pair("cos(t)", "sin(t)", 0, 3.3)
    asked: list[dict[str, Any]] = [
        {"xi_deg": "auto"},
        {"theta_deg": "auto"},
        {"xi_deg": "auto", "theta_deg": "auto"},
    ]
    for options in asked:
        error = request(f=circle, **options).refusal()
        assert "turns too much" in error.condition
        assert "orthodiagonal" in of_key(error, "shell.family")
        assert request(f=circle, g=STRAIGHT, xi_deg="auto").mended().design()


def test_bend_tighter_than_the_reach_of_f() -> None:
    what = request(g=graph("exp(-(x-10)**2)", 0, 20), columns=99)
    error = what.refusal()
    assert "into a bend of g" in error.condition
    assert re.search(r"at row (0|10) between columns \d+ and \d+", error.place)
    # The largest scale of f works, and 1 % more does not; so does the smallest of g.
    remedies = list(error.candidates)
    of_f = [float(str(each.changes.get("target.f.scale", 0))) for each in remedies]
    assert what.changed(remedies[0]).design()
    request(f=PARABOLA.scaled(1.01 * max(of_f)), g=what.g, columns=99).refusal()
    (first, *_) = (each for each in remedies if "target.g.scale" in each.changes)
    assert what.changed(first).design()


def test_plane_that_does_not_cross_g() -> None:
    what = request(plane_deg=10)
    error = what.refusal()
    assert "does not cross" in error.condition
    match = re.search(r"between ([\d.]+) and ([\d.]+)$", error.size)
    assert match is not None
    low, high = (float(each) for each in match.groups())
    for plane in (low + 0.01, high - 0.01):  # both ends of the interval are admissible
        try:
            request(f=PARABOLA.scaled(0.05), plane_deg=plane).design()
        except DesignError as other:
            assert "does not cross" not in other.condition  # noqa: PT017
    request(f=PARABOLA.scaled(0.05), plane_deg=low - 0.3).refusal()


def test_too_few_columns_for_any_plane() -> None:
    what = request(g=pair("20*cos(t)", "20*sin(t)", 0, 6), columns=2)
    error = what.refusal()
    columns = min(of_key(error, "pattern.columns"))
    assert request(g=what.g, columns=columns, f=PARABOLA.scaled(0.1)).design()
    request(g=what.g, columns=columns - 1, f=PARABOLA.scaled(0.1)).refusal()


def test_flat_sheet_that_overlaps_itself() -> None:
    # The flat sheet turns by sin(xi/2) of what g turns: 7 * 0.97 is more than a full turn.
    ring = pair("20*cos(t)", "20*sin(t)", 0, 7)
    what = request(f=graph("0.1*x", -1, 1), g=ring, columns=60, xi_deg=150)
    error = what.refusal()
    assert "overlaps itself" in error.condition
    for mended in what.candidates(error):
        assert mended.design()


def test_flaps_that_overlap_in_the_flat_sheet() -> None:
    # Flat, the ring turns by 6.2 * sin(80 degrees) = 6.1: almost a full turn.
    ring = pair("20*cos(t)", "20*sin(t)", 0, 6.2)
    what = request(f=graph("0.05*x", -1, 1), g=ring, columns=60, xi_deg=160, flap=4.0)
    error = what.refusal()
    assert "flaps overlap" in error.condition
    assert what.improved(error).design()
    assert what.changed(Remedy({"pattern.flap": 0})).design()


def test_too_few_columns_are_said_aloud() -> None:
    # Ten periods on nine columns (the example): equal spacing gives a straight line.
    ten_periods = graph("sin(x)", 0, 20 * np.pi)
    for spacing in ("curvature", "equal"):
        design = request(g=ten_periods, columns=9, spacing=spacing).design()
        assert "9 columns leaves g by" in design.warnings[0]
        assert design.closeness["g"].max > 0.9
    assert request(g=ten_periods, columns=161, f=PARABOLA.scaled(0.5)).design().warnings == ()
    assert request(g=STRAIGHT, columns=2).design().warnings == ()


def test_unusable_curve_is_named() -> None:
    with pytest.raises(CurveError, match=r"^f at parameter"):
        request(f=graph("1/x", -1, 1)).design()
    with pytest.raises(CurveError, match=r"^g at parameter"):
        request(g=graph("1/x", -1, 1)).design()


def test_f_may_run_either_way() -> None:
    leftwards = request(f=pair("cos(t)", "sin(t)", 0.8, 2.3)).design()
    rightwards = request(f=pair("-cos(t)", "sin(t)", np.pi - 2.3, np.pi - 0.8)).design()
    np.testing.assert_allclose(
        leftwards.mechanism.positions(1.0), rightwards.mechanism.positions(1.0), atol=1e-6
    )


def test_asymmetric_f_stands_to_the_right_of_g_and_upright() -> None:
    # Contract: f's y axis is +z; f's x axis lies to the right, seen along g.
    f = graph("0.3*x + 0.1*sin(x)", 0, 2)
    design = request(f=f, g=STRAIGHT, xi_deg=np.rad2deg(1.0)).design()
    locked = design.mechanism.positions(np.pi)
    column = locked[:, 1]
    assert column[-1, 2] > column[0, 2]
    assert column[-1, 1] < column[0, 1]
    end = f.position(2.0) - f.position(0.0)
    np.testing.assert_allclose(column[-1] - column[0], [0.0, -end[0], end[1]], atol=1e-12)


def test_targets_are_placed_on_the_locked_shell() -> None:
    for plane in (np.pi / 2, 1.1):
        design = request(plane_deg=np.rad2deg(plane), theta_deg=np.rad2deg(0.01)).design()
        locked = design.mechanism.positions(np.pi)
        np.testing.assert_allclose(design.targets["f"][[0, -1]], locked[[0, -1], 1], atol=1e-12)
        np.testing.assert_allclose(design.targets["g"][[0, -1]], locked[5, [1, -2]], atol=1e-12)


def test_panels_lost_in_rounding_are_refused() -> None:
    error = request(flap=1e-12).refusal()
    assert "too narrow or too wide" in error.condition
    assert request().improved(error).design()
    request(flap=1e300).refusal()
    request(flap=1e-320).refusal()
    assert "a panel is so small" in request(f=graph("-1e9*x**2", -1e-9, 1e-9)).refusal().condition


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("rows", 8),
        ("rows", 0),
        ("columns", 1),
        ("flap", -1.0),
        ("flap", float("nan")),
        ("xi_deg", -1.0),
        ("xi_deg", 180.0),
        ("theta_deg", float("nan")),
        ("plane_deg", 0.0),
        ("flap_side", ["left", "right"]),
        ("spacing", "even"),
        ("placement", "outside"),
    ],
)
def test_parameters_without_meaning_are_refused(name: str, value: Any) -> None:
    with pytest.raises(InputError, match=rf"^ParallelRepeatingPattern: {name}(\[0\])?: "):
        request(**{name: value}).design()


def test_places_are_named_as_f_was_drawn() -> None:
    # Steepest at t = 1, where the curve drawn from right to left is at (-1, -1).
    error = request(f=pair("-t", "-t**2", -0.2, 1), xi_deg=80).refusal()
    assert error.place == "at the point (-1, -1) of f"


def test_a_coarse_row_that_stretches_f_draws_a_warning() -> None:
    design = request(columns=5).design()
    assert any("f is stretched" in warning for warning in design.warnings)


def test_column_scales() -> None:
    # Rows stay parallel to g, so (lambda t)' is parallel to g': lambda'/lambda is cot(delta) times
    # the turning of t, t being to the right of g. On a circle lambda grows as exp(cot(delta) turn).
    arc = pair("20*cos(t)", "20*sin(t)", 0, 1)
    oblique = request(g=arc, columns=81, plane_deg=60).design().parameters["column_scale"]
    assert oblique == pytest.approx([1, np.exp(1 / np.tan(np.pi / 3))], rel=1e-3)
    square = request(g=arc, columns=81).design().parameters["column_scale"]
    assert square == pytest.approx([1, 1], abs=1e-9)


def test_polyline_g_is_followed_exactly() -> None:
    corners = [[0, 0], [6, 1], [12, -1], [20, 0]]
    g = curve_from_points(corners, smooth=False)
    design = request(g=g, columns=10).design()
    assert design.closeness["g"].max < 1e-12


def test_balanced_row_errs_on_both_sides_of_g() -> None:
    inscribed, balanced = (
        request(placement=placement).design() for placement in ("inscribed", "balanced")
    )
    assert balanced.parameters["placement"] == "balanced"
    assert 0.5 < balanced.closeness["g"].max / inscribed.closeness["g"].max < 0.6
    mechanism = balanced.mechanism
    assert isinstance(mechanism, ParallelRepeating)
    locked = mechanism.positions(np.pi)[5, 1:-1]
    # The locked middle row is the polyline, off g by as much as its edges are.
    vertices = np.stack([mechanism.points.real, mechanism.points.imag], axis=-1)
    np.testing.assert_allclose(locked[:, :2], vertices, atol=1e-12)
    np.testing.assert_allclose(locked[:, 2], 0, atol=1e-12)
    _, off = Nearest.to(trace_curve(WAVE))(locked[:, :2])
    np.testing.assert_allclose(off[[0, -1]], 0, atol=1e-12)
    assert off.max() == pytest.approx(balanced.closeness["g"].max, rel=1e-3)
    # Columns keep the directions of g at their parameters, where they stand on g's normals.
    foot, _ = Nearest.to(trace_curve(WAVE))(locked[1:-1, :2])
    slope = 0.5 * np.pi * np.cos(np.pi * foot[:, 0] / 10)
    np.testing.assert_allclose(
        np.angle(mechanism.axes[1:-1]), np.arctan(slope) - np.pi / 2, atol=1e-6
    )


def test_balanced_row_on_a_polyline_is_the_inscribed_one() -> None:
    g = curve_from_points([[0, 0], [6, 1], [12, -1], [20, 0]], smooth=False)
    inscribed, balanced = (
        request(g=g, placement=placement).design().mechanism.positions(2.0)
        for placement in ("inscribed", "balanced")
    )
    np.testing.assert_array_equal(balanced, inscribed)


@pytest.mark.parametrize(("rows", "columns"), [(1, 2), (1, 11), (9, 2), (3, 3)])
def test_smallest_sheets(rows: int, columns: int) -> None:
    f = PARABOLA.scaled(0.2)
    design = request(f=f, g=graph("x**2/40", 0, 10), rows=rows, columns=columns).design()
    assert design.mechanism.positions(1.0).shape == (rows + 2, columns + 2, 3)
