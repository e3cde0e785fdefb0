"""What a design meets, what the family refuses, and that what it says works."""

import re
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import CurveError, DesignError, InputError, Remedy
from orishell.curves import Curve, trace_curve
from orishell.design import Design
from orishell.families.longitudinal_linear_repeating import (
    LongitudinalLinearRepeating,
    LongitudinalPattern,
    Sectors,
    design_longitudinal_linear_repeating,
)
from orishell.families.longitudinal_linear_repeating.section import Section
from orishell.families.longitudinal_linear_repeating.target import Profile
from orishell.locking import lock_without_clash
from orishell.motion import FoldingMotion
from orishell.verification.residuals import measure_residuals
from samples import thorough
from strategies import graph, pair

ARC = pair("cos(t)", "sin(t)", 0.3, 2.8416)
PAPER = Sectors.from_degrees([85, 80, 95, 100])


def line(length: float) -> Curve:
    return graph("0*x", 0, length)


def design(f: Curve = ARC, g: Curve | None = None, **options: Any) -> Design:
    given = {"rows": 7, "columns": 9, "sector_deg": PAPER.degrees, **options}
    return design_longitudinal_linear_repeating(
        f, line(3) if g is None else g, LongitudinalPattern(**given)
    )


def mechanism_of(made: Design) -> LongitudinalLinearRepeating:
    assert isinstance(made.mechanism, LongitudinalLinearRepeating)
    return made.mechanism


def first(error: DesignError, key: str) -> Any:
    """The first value that a refusal's candidates have at a key."""
    return next(each.changes[key] for each in error.candidates if key in each.changes)


def refusal(**options: Any) -> DesignError:
    with pytest.raises(DesignError) as caught:
        design(**options)
    return caught.value


def require_rigid(made: Design) -> None:
    motion = FoldingMotion(made.mechanism, 7)
    residuals, assignment = measure_residuals(motion, motion.flat)
    assert residuals.panel_length <= 1e-12
    assert residuals.planarity <= 1e-12
    assert residuals.fold_angle_rad <= 1e-9
    assert assignment.constant
    assert assignment.maekawa


@pytest.mark.parametrize(
    ("f", "length"),
    [
        (ARC, 1.2),
        (graph("-x**2", -1, 1), 1.2),
        (graph("x**2", -1, 1), 1.2),
        (graph("exp(0.8*x)", -1, 1), 1.2),
        (pair("cos(t)", "0.6*sin(t)", 0.4, 2.7), 1.2),
    ],
)
@pytest.mark.parametrize("first_row", ["F", "S"])
def test_column_1_follows_f(f: Curve, length: float, first_row: str) -> None:
    made = design(f, line(length), rows=8, columns=4, first_row=first_row, sector_deg="auto")
    require_rigid(made)
    size = trace_curve(f).length
    assert made.closeness["f"].max < 0.02 * size
    # Seen along g, f's x axis points to the right and its y axis is +z.
    stage = made.mechanism.positions(made.mechanism.target_drive)
    column = stage[:, 1]
    ends = f.position(f.stop) - f.position(f.start)
    ends = ends * np.sign(ends[0])
    np.testing.assert_allclose(-(column[-1] - column[0])[1], ends[0], atol=0.03 * size)
    np.testing.assert_allclose((column[-1] - column[0])[2], ends[1], atol=0.03 * size)


def test_closer_with_more_rows() -> None:
    # The polygon touches f from both sides: second order in the number of rows.
    distances = [
        design(g=line(1.5), rows=rows, columns=4, sector_deg="auto").closeness["f"].max
        for rows in (4, 9, 19)
    ]
    assert distances[1] < distances[0] / 3
    assert distances[2] < distances[1] / 3


def test_stage_turns_column_1_as_much_as_f() -> None:
    made = design()
    mechanism = mechanism_of(made)
    section = Section.of(mechanism.columns, 7, "F", mechanism.target_drive, 1)
    assert abs(section.turning) == pytest.approx(2.5416, abs=1e-10)
    # Measured on the shell: turns of column 1 seen along g.
    column = mechanism.positions(mechanism.target_drive)[:, 1]
    seen = -column[:, 1] + 1j * column[:, 2]
    edges = np.diff(seen)
    np.testing.assert_allclose(np.angle(edges[1:] / edges[:-1]), section.turns[1:-1], atol=1e-12)
    # All lengths of one kind have the same share across g; the row is as long as g.
    across = np.abs(edges) / np.linalg.norm(np.diff(column, axis=0), axis=-1)
    np.testing.assert_allclose(across, section.across, atol=1e-12)
    low, high = np.array(made.parameters["row_span"], dtype=float)
    assert high - low == pytest.approx(3, abs=1e-9)


def test_placement() -> None:
    slanted = pair("1 + 2*t", "2 - t", 0, 1.2)
    made = design(g=slanted)
    stage = made.mechanism.positions(made.mechanism.target_drive)
    start = np.array([1, 2, 0])
    forward = np.array([2, -1, 0]) / np.sqrt(5)
    # Column 1 stands at g's start; f and g where the report says they are.
    assert ((stage[:, 1] - start) @ forward).mean() == pytest.approx(0, abs=1e-12)
    np.testing.assert_allclose(made.targets["g"][0], start, atol=1e-12)
    assert np.abs((made.targets["f"] - start) @ forward).max() < 1e-12
    nearest = np.linalg.norm(stage[None, :, 1] - made.targets["f"][:, None], axis=-1).min(axis=0)
    assert nearest.max() < 0.05
    # The flat sheet lies in a plane parallel to z = 0, seen from +z.
    flat = made.mechanism.positions(0.0)
    assert np.ptp(flat[..., 2]) < 1e-14


def test_motion_does_not_jump() -> None:
    made = design(graph("x**2", -1, 1), line(1.7), rows=5, columns=6)
    end = made.mechanism.target_drive
    steps = [
        np.linalg.norm(
            np.diff(made.mechanism.positions(np.linspace(0.1 * end, end, n)), axis=0), axis=-1
        ).max()
        for n in (51, 201)
    ]
    assert steps[1] == pytest.approx(steps[0] / 4, rel=0.1)


def test_given_lengths() -> None:
    column = [1.0, 1.1, 0.9, 1.0, 1.0, 1.0, 1.0, 1.2]
    made = design(column_lengths=column)
    found = np.array(made.parameters["column_lengths"], dtype=float)
    np.testing.assert_allclose(found / found[0], column, rtol=1e-12)
    require_rigid(made)
    # geometry.md section 5: these rows over 5 x 9.
    row = [1.4, 0.23, 1.0, 1.9] * 2
    made = design(g=line(3.4), rows=5, row_lengths=row)
    found = np.array(made.parameters["row_lengths"], dtype=float)
    np.testing.assert_allclose(found / found[0], np.array(row) / 1.4, rtol=1e-9)
    require_rigid(made)


def test_given_stage() -> None:
    made = design(stage_deg=np.rad2deg(float(np.deg2rad(2))))
    assert made.parameters["stage_deg"] == pytest.approx(2)
    require_rigid(made)
    assert design().closeness["f"].max < made.closeness["f"].max


def test_stage_beyond_the_end_of_the_motion() -> None:
    error = refusal(stage_deg=np.rad2deg(2.5), rows=2, columns=3, g=line(1))
    nearest = float(np.deg2rad(first(error, "pattern.stage_deg")))
    assert design(g=line(0.8), rows=2, columns=3, stage_deg=np.rad2deg(nearest))


def test_sector_angles_auto() -> None:
    made = design(graph("-0.1*x**2", -1, 1), sector_deg="auto")
    require_rigid(made)
    assert made.closeness["f"].max < 2e-3
    longest_to_shortest = made.parameters["longest_to_shortest"]
    assert isinstance(longest_to_shortest, float)
    assert longest_to_shortest < 8


def test_lock() -> None:
    made = design()
    assert lock_without_clash(made).cause == "crease"
    assert made.mechanism.end_drive == pytest.approx(np.deg2rad(119.747), abs=1e-4)
    assert made.mechanism.target_drive < made.mechanism.end_drive


def test_without_the_period() -> None:
    # The paper's Remark 1.
    made = design(couplings=["solve"] * 8)
    require_rigid(made)
    mixed = ["solve", "parallel", "parallel", "solve"]
    require_rigid(design(g=line(1.2), rows=5, columns=5, couplings=mixed))
    with pytest.raises(InputError, match="expected 8"):
        design(couplings=["solve"] * 2)


def test_s_rows_stay_planar() -> None:
    made = design()
    planar, f_rows = made.parameters["planar"], made.parameters["f_row_out_of_plane"]
    assert planar == ["S rows"]
    assert isinstance(f_rows, float)
    assert f_rows > 1e-7


def test_f_that_is_not_convex() -> None:
    wave = graph("sin(x)", 0, 5)
    error = refusal(f=wave)
    assert "not convex" in error.condition
    assert re.search(r"parameter 3\.1[34]", error.place)
    assert Profile.of(trace_curve(wave.part_of_drawn(*first(error, "target.f.range"))))
    # The same part, whichever way f was drawn.
    backwards = pair("5-t", "sin(5-t)", 0, 5)
    part = backwards.part_of_drawn(*first(refusal(f=backwards), "target.f.range"))
    assert Profile.of(trace_curve(part))


def test_straight_f() -> None:
    assert "straight" in refusal(f=graph("0.3*x", 0, 2)).condition


def test_g_that_is_not_straight() -> None:
    error = refusal(g=graph("x**2", 0, 2))
    assert "g is not straight" in error.condition
    assert first(error, "target.g.range") == [0.0, 4.64678]


@pytest.mark.parametrize("length", [0.3, 30.0])
def test_length_of_g_out_of_reach(length: float) -> None:
    error = refusal(g=line(length))
    scales = [
        float(str(each.changes["target.g.scale"]))
        for each in error.candidates
        if "target.g.scale" in each.changes
    ]
    # The limit of the lengths comes first, where another condition may still fail.
    assert "zero or negative length" in refusal(g=line(length * scales[0] ** (1 / 1.01))).condition
    assert any(made(g=line(length * scale)) for scale in scales)


def made(**options: Any) -> bool:
    try:
        return bool(design(**options))
    except DesignError:
        return False


def test_more_turning_than_rows() -> None:
    error = refusal(f=pair("cos(t)", "sin(t)", 0.2, 6.2), rows=1, columns=3, g=line(1))
    rows = first(error, "pattern.rows")
    assert "cannot turn as much as f" in error.condition
    assert design(pair("cos(t)", "sin(t)", 0.2, 6.2), line(1), rows=rows, columns=3)


def test_less_turning_than_the_rows_fan_out() -> None:
    flat_f = graph("-0.1*x**2", -1, 1)
    error = refusal(f=flat_f, rows=9, g=line(1))
    rows = first(error, "pattern.rows")
    with pytest.raises(DesignError) as caught:
        design(flat_f, line(1), rows=rows)
    assert "fan out" not in caught.value.size


def test_a_corner_of_f() -> None:
    from orishell.curves import curve_from_points

    corner = curve_from_points([[0, 0], [1, 1], [2, 0]], smooth=False)
    error = refusal(f=corner, rows=9)
    assert "bends too sharply" in error.condition


@thorough
def test_sizes_that_do_not_exist() -> None:
    largest = Remedy({"pattern.rows": 35, "pattern.columns": 35})
    assert largest in list(refusal(rows=40, columns=40).candidates)


def test_sine_version_follows_no_convex_curve() -> None:
    assert "sine version" in refusal(solution=1, rows=2, columns=2).condition


def test_rows_that_fold_to_both_sides() -> None:
    error = refusal(sector_deg=[85, 80, 85, 80.5], rows=3, columns=3)
    assert first(error, "pattern.sector_deg") == "auto"
    assert design(rows=3, columns=3, sector_deg="auto")


def test_unusable_input() -> None:
    with pytest.raises(CurveError, match=r"^f at parameter"):
        design(f=graph("1/x", -1, 1))
    with pytest.raises(InputError, match="column_lengths"):
        design(column_lengths=[1.0, 2.0])
    with pytest.raises(InputError, match="row_lengths"):
        design(row_lengths=[1.0, -1.0] * 4)


@thorough
@pytest.mark.slow
def test_99_x_99_near_90_degrees() -> None:
    made = design(
        graph("-0.2*x**2", -1, 1),
        line(2),
        rows=99,
        columns=99,
        sector_deg=[89.95, 89.9, 90.05, 90.1],
    )
    motion = FoldingMotion(made.mechanism, 4)
    residuals, assignment = measure_residuals(motion, motion.flat)
    assert residuals.panel_length <= 1e-11
    assert residuals.fold_angle_rad <= 1e-9
    assert assignment.constant
    assert made.closeness["f"].max < 1e-4


def test_panels_lost_in_rounding_are_refused() -> None:
    for options in (
        {"flap": 1e-12},
        {"column_lengths": [1e-12, 1, 1, 1, 1, 1, 1, 1e-12]},
        {"rows": 1, "row_lengths": [1, 1e-13, 1, 1, 1, 1, 1, 1]},
    ):
        assert "rounding" in refusal(**options).condition


def test_a_flap_far_too_wide_gets_one_that_fits() -> None:
    error = refusal(flap=1e9)
    assert design(flap=first(error, "pattern.flap"))
