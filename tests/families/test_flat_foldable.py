"""Designs that fold flat: planes that bisect g's polyline, and rows of two headings.

A vertex of four creases folds flat if alternate sector angles sum to pi (Kawasaki's condition). It
is asked of columns 2 ... n-1: creases of columns 1 and n meet the flaps, which lock.
"""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import ValidationError

from orishell.conventions.errors import DesignError, InputError
from orishell.curves import Curve, curve_from_points, run_along_axis, trace_curve
from orishell.design import Design
from orishell.families.orthodiagonal import Orthodiagonal
from orishell.families.orthodiagonal.pattern import OrthodiagonalPattern
from orishell.families.parallel_repeating import ParallelRepeating
from orishell.families.parallel_repeating.pattern import ParallelRepeatingPattern
from orishell.families.parallel_repeating.profile import fit_profile
from orishell.families.pattern import Pattern
from orishell.families.tolerance import Tolerance
from orishell.motion import diagonal
from orishell.polylines import measure_closeness, place_chords
from samples import THOROUGH
from strategies import (
    Request,
    graph,
    orthodiagonal,
    pair,
    parallel_repeating,
    requests,
)

EXAMPLES = 200 if THOROUGH else 12
PARABOLA, WAVE = graph("-x**2", -1, 1), graph("5*sin(pi*x/10)", 0, 20)
RIPPLE = graph("0.25*sin(pi*x/2)", 0, 4)


def kawasaki(angles: np.ndarray) -> float:
    """The largest residual, of sector angles (..., n, 4) in the order RU, LU, LD, RD."""
    inner = angles[..., 1:-1, :]
    both = np.stack([inner[..., 0] + inner[..., 2], inner[..., 1] + inner[..., 3]]) - np.pi
    return float(np.abs(both).max(initial=0.0))


def without(request: Request, *keys: str, **more: Any) -> Request:
    kept = {key: value for key, value in request.options.items() if key not in keys}
    return replace(request, options={**kept, **more})


def bisected() -> st.SearchStrategy[Request]:
    return requests().map(lambda each: without(each, "plane_deg", plane="bisector"))


@settings(max_examples=EXAMPLES)
@given(bisected())
def test_planes_that_bisect_make_any_g_flat_foldable(request: Request) -> None:
    request = request.mended()
    mechanism = request.design().mechanism
    assert isinstance(mechanism, ParallelRepeating)
    assert kawasaki(mechanism.sector_angles()) < 1e-12
    # The slope tan(xi_j/2) sin(delta), from the locked state, is that of all inner panel columns.
    delta = np.angle(np.diff(mechanism.points) / mechanism.axes[:-1])
    slope = mechanism.column_scales()[:-1] * np.sin(delta)
    np.testing.assert_allclose(slope, slope[0], rtol=1e-12)
    # The target is met as with other planes: the row on g's polyline, column 1 on f's staircase.
    options = request.options
    f = fit_profile(
        request.f,
        options["rows"] + 1,
        *np.deg2rad([options["xi_deg"], options["theta_deg"]]).tolist(),
    )
    g = trace_curve(request.g).in_own_frame()
    chords = place_chords(g, options["columns"], options["spacing"], options["placement"])
    locked = mechanism.positions(mechanism.target_drive)[:, mechanism.inner_columns]
    size = diagonal(mechanism.positions(0.0))
    middle = len(locked) // 2
    np.testing.assert_allclose(locked[middle, :, :2], chords.vertices, atol=1e-12 * size)
    across = (locked[:, 0, :2] - locked[middle, 0, :2]) @ np.array([1, 1j])
    across = across * mechanism.axes[0].conj()
    column = f.staircase.vertices - f.staircase.vertices[middle]
    np.testing.assert_allclose(across, column[:, 0], atol=1e-12 * size)
    np.testing.assert_allclose(locked[:, 0, 2], column[:, 1], atol=1e-12 * size)
    # Columns 1 and n stand square to g itself.
    square = np.exp(1j * (g.heading_at(chords.parameters[[0, -1]]) - np.pi / 2))
    np.testing.assert_allclose(mechanism.axes[[0, -1]], square, atol=1e-12)


def test_a_zigzag_row_makes_any_g_flat_foldable() -> None:
    rng, refused = np.random.default_rng(3), list[str]()
    for _ in range(EXAMPLES):
        a, b, c, d = rng.uniform(-0.3, 0.3, 4).round(4)
        half = rng.uniform(0.5, 2)
        g = graph(f"{a}*x + {b}*x**2/2 + {c}*x**3/6 + {d}*sin(2*x)", -half, half)
        rows, columns = 2 * rng.integers(1, 8) + 1, rng.integers(3, 16)
        request = orthodiagonal(
            PARABOLA, g, rows=rows, columns=columns, row="zigzag", heading_deg="auto", flap=0
        )
        try:
            design = request.design()
        except DesignError as error:
            refused.append(error.condition)
            continue
        require_flat_foldable_zigzag(design, g)
    # A few g's leave the normal farther than the zigzag of f allows.
    assert len(refused) < 20
    assert all("neighbouring rows meet" in each for each in refused)


def require_flat_foldable_zigzag(design: Design, g: Curve) -> None:
    mechanism, found = design.mechanism, design.parameters
    assert isinstance(mechanism, Orthodiagonal)
    assert kawasaki(mechanism.sector_angles()) < 1e-12
    # Edges lie alternately at one angle to either side of the normal of f's plane.
    eps = np.angle(np.diff(mechanism.points) * np.exp(1j * mechanism.heading)) - np.pi / 2
    xi = np.deg2rad(np.asarray(found["row_angle_deg"], np.float64))
    np.testing.assert_allclose(np.abs(eps), (np.pi - xi) / 2, atol=1e-11)
    assert (np.sign(eps[1:]) == -np.sign(eps[:-1])).all()
    # The locked row is that zigzag, from one end of g to the other, as far from g as is said.
    trace = run_along_axis(trace_curve(g).in_own_frame())
    size = diagonal(mechanism.positions(0.0))
    ends = trace.points[[0, -1]] @ np.array([1, 1j])
    np.testing.assert_allclose(mechanism.points[[0, -1]], ends, atol=1e-12 * size)
    vertices = np.stack([mechanism.points.real, mechanism.points.imag], axis=-1)
    assert design.closeness["g"] == measure_closeness(trace, vertices)
    if mechanism.tilt == 0:
        row = mechanism.positions(mechanism.target_drive)[
            mechanism.grid.rows // 2, mechanism.inner_columns
        ]
        np.testing.assert_allclose(row[:, :2], vertices, atol=1e-12 * size)


@pytest.mark.parametrize(
    "request_",
    [
        parallel_repeating(PARABOLA, WAVE, rows=9, columns=11, flap=0, plane="bisector"),
        orthodiagonal(PARABOLA, RIPPLE, rows=9, columns=14, depth=0.12, flap=0, row="zigzag"),
    ],
    ids=["parallel-repeating", "orthodiagonal"],
)
def test_all_row_creases_of_a_row_fold_alike(request_: Request) -> None:
    # So they close at once, whatever comes after the target.
    mechanism = request_.design().mechanism
    folds = np.abs(mechanism.fold_angles(np.array([0.4, 1.7, np.pi])).row)
    np.testing.assert_allclose(folds, folds[..., :1] + np.zeros_like(folds), atol=1e-12)


def test_bisecting_planes_come_to_stand_square_to_g() -> None:
    # On Figure 1's wave; the worst column is the one on its inflection.
    off = [
        parallel_repeating(
            PARABOLA, WAVE, rows=9, columns=n, xi_deg=np.rad2deg(0.9), plane="bisector"
        )
        .design()
        .parameters["plane_off_deg"]
        for n in (11, 21, 41)
    ]
    assert off == pytest.approx([3.359, 1.290, 0.504], abs=1e-3)
    # On an arc they do from the first, for chords of equal length are symmetric about its radii.
    arc = graph("sqrt(400 - x**2)", -9, 9)
    design = parallel_repeating(PARABOLA, arc, rows=9, columns=8, plane="bisector").design()
    assert design.parameters["plane_off_deg"] == pytest.approx(0, abs=1e-4)
    assert design.parameters["column_scale"] == pytest.approx([1, 1], abs=1e-6)


def test_planes_bisect_corners_of_g_as_its_tangents_do() -> None:
    g = curve_from_points([[0, 0], [6, 1], [12, -1], [20, 0]], smooth=False)
    bisector, tangent = (
        parallel_repeating(PARABOLA, g, rows=9, columns=10, plane=planes).design().mechanism
        for planes in ("bisector", "tangent")
    )
    np.testing.assert_allclose(bisector.positions(2.0), tangent.positions(2.0), atol=1e-12)


def test_end_planes_that_do_not_cross_need_more_columns() -> None:
    # Two chords of a circle and its tangents at both ends, which turn by more than 90 degrees.
    circle = pair("10*cos(t)", "10*sin(t)", 0, 5)
    asked = parallel_repeating(PARABOLA, circle, rows=5, columns=2, plane="bisector")
    error = asked.refusal()
    assert error.condition == "f's plane does not cross the chord of g"
    assert "plane_deg" not in error.size
    assert {key for remedy in error.candidates for key in remedy.changes} == {"pattern.columns"}
    assert asked.improved(asked.refusal()).design().parameters["plane"] == "bisector"


def test_a_straight_g_gets_the_flattest_zigzag() -> None:
    for columns in (3, 4, 12):
        design = orthodiagonal(
            PARABOLA, graph("0*x", 0, 4), rows=9, columns=columns, row="zigzag", depth=0.3
        ).design()
        assert design.parameters["row_angle_deg"] == 150
        assert design.parameters["heading_deg"] == 90
        # Inner edges rise by twice the distance from g, both end edges by once.
        rise = 4 * np.tan(np.deg2rad(15)) / (2 * (columns - 2))
        assert design.closeness["g"].max == pytest.approx(rise)
        assert not design.warnings


def test_the_heading_of_a_zigzag_follows_the_chord_of_g() -> None:
    slanted = graph("0.75*x", 0, 4)
    design = orthodiagonal(
        PARABOLA, slanted, rows=9, columns=13, depth=0.2, heading_deg="auto", row="zigzag"
    ).design()
    assert design.parameters["heading_deg"] == pytest.approx(np.rad2deg(np.arctan(4 / 3)))
    assert design.parameters["row_heading_interval_deg"] == pytest.approx(
        np.rad2deg(np.arctan(4 / 3)) + np.array([-15, 15])
    )
    # At the usual heading rows would shift too far; "auto" is among what is offered.
    asked = orthodiagonal(PARABOLA, slanted, rows=9, columns=13, depth=0.2, row="zigzag")
    error = asked.refusal()
    assert "heading_deg must lie" not in error.size
    assert any(each.changes == {"pattern.heading_deg": "auto"} for each in error.candidates)


def test_a_zigzag_too_open_for_g_is_refused_with_angles_that_work() -> None:
    asked = orthodiagonal(
        PARABOLA, RIPPLE, rows=9, columns=25, depth=0.12, row="zigzag", row_angle_deg=150
    )
    error = asked.refusal()
    assert error.condition == "row_angle_deg = 150 is too large for g"
    # The steepest tangent is arctan(pi/8) from the axis.
    assert f"must stay below {180 - 2 * np.rad2deg(np.arctan(np.pi / 8)):.4f}" in error.size
    assert asked.improved(error).design()
    ring = pair("-cos(t)", "sin(t)", -0.2, 3.3)
    turns = orthodiagonal(PARABOLA, ring, rows=9, columns=9, depth=0.12, row="zigzag").refusal()
    assert "g turns too much for a staircase" in turns.condition
    two = orthodiagonal(PARABOLA, RIPPLE, rows=9, columns=2, depth=0.12, row="zigzag")
    assert "needs a corner" in two.refusal().condition
    assert two.improved(two.refusal()).design()


def test_a_coarse_zigzag_draws_a_warning() -> None:
    def warned(columns: int) -> list[str]:
        design: Design = orthodiagonal(
            PARABOLA, RIPPLE, rows=9, columns=columns, depth=0.2, row="zigzag"
        ).design()
        return [each for each in design.warnings if "leaves g by" in each]

    assert warned(9)
    assert not warned(41)


SIZE: dict[str, Any] = {"rows": 9, "columns": 11}


@pytest.mark.parametrize(
    ("family", "wrong", "key"),
    [
        (ParallelRepeatingPattern, {"plane": "bisector", "plane_deg": 80}, "plane_deg"),
        (OrthodiagonalPattern, {"row_angle_deg": 120}, "row_angle_deg"),
        (OrthodiagonalPattern, {"row": "zigzag", "spacing": "equal"}, "spacing"),
        (OrthodiagonalPattern, {"row": "zigzag", "placement": "balanced"}, "placement"),
    ],
)
def test_what_does_not_go_together_is_refused_alike(
    family: type[Pattern], wrong: dict[str, Any], key: str
) -> None:
    with pytest.raises(ValidationError, match="1 validation error") as caught:
        family.model_validate({**SIZE, **wrong})
    assert caught.value.errors()[0]["ctx"]["key"] == key
    with pytest.raises(InputError, match=rf"Pattern: {key}: this value does not fit"):
        family(**{**SIZE, **wrong})


@pytest.mark.parametrize(
    ("page", "request_"),
    [
        ("parallel-repeating", parallel_repeating(PARABOLA, WAVE, **SIZE, plane="bisector")),
        ("orthodiagonal", orthodiagonal(PARABOLA, RIPPLE, **SIZE, depth=0.2, row="zigzag")),
    ],
)
def test_the_guide_explains_what_the_report_says_of_them(page: str, request_: Request) -> None:
    text = (Path(__file__).parents[2] / "docs" / "guide" / f"{page}.md").read_text("utf-8")
    for key in request_.design().parameters:
        assert re.search(rf"(?m)^\| .*`{key}`.* \|", text), key


def test_what_goes_together_is_taken() -> None:
    assert ParallelRepeatingPattern(**SIZE, plane="bisector", plane_deg=90).design(PARABOLA, WAVE)
    pattern = OrthodiagonalPattern(**SIZE, row="zigzag", row_angle_deg=120, depth=0.2)
    found = pattern.design(PARABOLA, RIPPLE).parameters
    assert (found["row"], found["row_angle_deg"]) == ("zigzag", 120)
    assert "placement" not in found
    # A tolerance leaves the kind of row as it is.
    assert list(pattern.variants(PARABOLA, Tolerance(surface=0.1)).telling) == [pattern]
