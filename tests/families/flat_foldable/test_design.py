"""Flat-foldable sheets by a few numbers and by lists: what is asked for is what comes out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import DesignError, InputError
from orishell.design import Design
from orishell.design_file import DesignFile, check_design
from orishell.families.flat_foldable import FlatFoldable, FlatFoldablePattern, design_flat_foldable
from orishell.shell.make import make_shell
from rigid import distance_after_motion

Array = np.ndarray
SIZE: dict[str, Any] = {"rows": 7, "columns": 8}
SHEETS: list[dict[str, Any]] = [
    {"sheet": "miura"},
    {"sheet": "arch", "turn_deg": 100},
    {"sheet": "arch", "turn_deg": 70, "rows": 6, "growth": 2},
    {"sheet": "fan", "turn_deg": -30, "sector_deg": 70},
]


def file_of(*, tables: dict[str, Any] | None = None, **pattern: Any) -> DesignFile:
    shell = {"family": "flat-foldable", "unit": "m"}
    return check_design(
        {"shell": shell, "pattern": {**SIZE, **pattern}, **(tables or {})}, Path("shell.toml")
    )


def designed(**pattern: Any) -> Design:
    return file_of(**pattern).pattern.design_without_target()


def mechanism_of(design: Design) -> FlatFoldable:
    assert isinstance(design.mechanism, FlatFoldable)
    return design.mechanism


def target(design: Design) -> Array:
    return design.mechanism.positions(design.mechanism.target_drive)


@pytest.mark.parametrize("asked", SHEETS)
def test_a_sheet_typed_in_by_its_lists_is_the_same_shell(asked: dict[str, Any]) -> None:
    design = designed(**asked)
    keys = type(file_of().pattern).model_fields
    lists = {
        key: value
        for key, value in design.parameters.items()
        if key in keys and isinstance(value, list)
    }
    assert len(lists) == 11
    rows = asked.get("rows", SIZE["rows"])
    again = designed(sheet="lists", rows=rows, **lists)
    # In the same place, but for angles that are written in degrees.
    np.testing.assert_allclose(target(again), target(design), atol=1e-12)
    flat, other = (each.mechanism.positions(0.0).reshape(-1, 3) for each in (design, again))
    assert distance_after_motion(flat, other) < 1e-11
    # Another fold angle is another state of the same sheet.
    folded = designed(sheet="lists", rows=rows, fold_deg=40, **lists)
    assert folded.mechanism.target_drive == pytest.approx(np.deg2rad(40), abs=1e-15)
    state = design.mechanism.positions(np.deg2rad(40)).reshape(-1, 3)
    assert distance_after_motion(state, target(folded).reshape(-1, 3)) < 1e-11


def test_columns_of_an_arch_turn_as_far_as_asked() -> None:
    for rows, turn in ((7, 100.0), (8, 60.0), (13, 170.0)):
        design = designed(sheet="arch", rows=rows, turn_deg=turn)
        shell = target(design)
        # Columns are straight in the flat sheet and plane in all states.
        column = shell[:, 4]
        assert np.ptp(column[:, 0]) < 1e-12
        ways = np.diff(column, axis=0)[:, 1:] @ np.array([1, 1j])
        ways = ways / np.abs(ways)
        # From row to row it turns to one side and back by less: headings of both by two rows.
        middle = np.angle(ways[1:] + ways[:-1])
        turned = np.unwrap(middle)
        steps = np.abs(np.diff(turned))
        np.testing.assert_allclose(steps, np.deg2rad(turn / rows), atol=1e-12)
        # It stands with its middle upwards, and with an odd number of rows on level feet.
        heights = shell[..., 2].mean(axis=1)
        assert heights[[0, -1]].max() < heights[2:-2].min()
        if rows % 2:
            assert np.ptp(shell[[0, -1], :, 2]) < 1e-12


def test_columns_of_a_fan_run_apart_by_the_angle_that_is_asked_for() -> None:
    flat = designed(sheet="fan", turn_deg=40).mechanism.positions(0.0)
    columns = (flat[-2] - flat[1])[1:-1, :2] @ np.array([1, 1j])
    assert np.rad2deg(np.angle(columns[-1] / columns[0])) == pytest.approx(40, abs=1e-11)
    widths = np.linalg.norm(flat[[0, -1], -2] - flat[[0, -1], 1], axis=-1)
    assert widths[1] > 1.5 * widths[0]


def test_growth_is_the_ratio_of_the_edges_of_a_column() -> None:
    design = designed(growth=3, column_length=0.5)
    edges = np.linalg.norm(np.diff(design.mechanism.positions(0.0), axis=0), axis=-1)
    np.testing.assert_allclose(edges[:, 1:-1], np.outer(0.5 * np.geomspace(1, 3, 8), np.ones(8)))


@pytest.mark.parametrize("asked", SHEETS)
def test_the_target_stands_level_about_the_origin(asked: dict[str, Any]) -> None:
    design = designed(**asked)
    mechanism = mechanism_of(design)
    assert mechanism.target_drive == pytest.approx(np.pi / 2, abs=1e-15)
    assert np.ptp(mechanism.positions(0.0)[..., 2]) < 1e-14
    shell = target(design)
    size = np.ptp(shell[..., 0])
    ends = shell[:, [1, 2, -3, -2]].mean(axis=0)
    along = ends[2:].mean(axis=0) - ends[:2].mean(axis=0)
    assert along[0] > 0.5 * size
    assert np.abs(along[1:]).max() < 0.3 * size


@pytest.mark.parametrize(
    ("wrong", "key"),
    [
        ({"row_folds_deg": [1.0]}, "row_folds_deg"),
        ({"sheet": "lists", "column_folds_deg": [50.0] * 8}, "row_folds_deg"),
        (
            {"sheet": "lists", "column_folds_deg": [50.0] * 8, "row_folds_deg": [80.0] * 3},
            "row_folds_deg",
        ),
        ({"turn_deg": 30}, "turn_deg"),
        ({"sheet": "arch", "turn_deg": -30}, "turn_deg"),
        ({"sheet": "cone"}, "sheet"),
    ],
)
def test_what_does_not_go_together_is_refused(wrong: dict[str, Any], key: str) -> None:
    with pytest.raises(InputError, match=key):
        file_of(**wrong)


@pytest.mark.parametrize(
    ("asked", "condition"),
    [
        ({"sheet": "arch", "turn_deg": 300, "rows": 4, "columns": 4}, "too large"),
        ({"sheet": "fan", "turn_deg": 180, "rows": 4, "columns": 4}, "too large"),
        (
            {
                "sheet": "lists",
                "row_folds_deg": [80.0, -80.0] * 3 + [80.0],
                "column_folds_deg": [50.0, -50.0] * 4,
                "row_angles_deg": [20.0, 150.0] * 4,
            },
            "no sheet",
        ),
        (
            {
                "sheet": "lists",
                "row_folds_deg": [80.0] * 7,
                "column_folds_deg": [50.0, -50.0, 80.0, 20.0] * 2,
            },
            "row 1 and column 3",
        ),
        (
            {
                "sheet": "lists",
                "row_folds_deg": [80.0] * 7,
                "column_folds_deg": [50.0, -50.0, 1e-8, 20.0] * 2,
            },
            "stays flat while others fold.*column 3",
        ),
    ],
)
def test_what_makes_no_sheet_is_refused_with_what_works(
    asked: dict[str, Any], condition: str
) -> None:
    with pytest.raises(DesignError, match=condition) as caught:
        make_shell(file_of(**asked))
    if "column 3" not in condition:
        assert caught.value.remedies
        remedied = file_of(**asked).changed(caught.value.remedies[0].changes)
        assert remedied.pattern.design_without_target()


@pytest.mark.parametrize("asked", SHEETS[:2])
def test_it_is_proved_to_fold_from_flat_to_the_flat_stack(asked: dict[str, Any]) -> None:
    file = file_of(tables={"deployment": {"from": "pack"}}, **asked)
    shell = make_shell(file, skip=("deviation", "weight", "stock", "cutting"))
    report = shell.report
    assert report.feasible
    assert report.lock.closes_to == pytest.approx(np.pi)
    assert report.residuals is not None
    assert report.residuals.panel_length < 1e-13
    packed = report.deployment.packed
    assert packed is not None
    assert packed.height < 1e-12


def test_functions_take_what_the_table_takes() -> None:
    one = designed(sheet="arch", turn_deg=80)
    other = design_flat_foldable(FlatFoldablePattern(**SIZE, sheet="arch", turn_deg=80.0))
    np.testing.assert_allclose(target(one), target(other), atol=1e-14)
    with pytest.raises(InputError, match="FlatFoldablePattern: turn_deg"):
        FlatFoldablePattern(**SIZE, turn_deg=20)
