"""Shells that stand level: on their corners, or with two sides of their rim on the ground."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import DesignError, InputError
from orishell.deployment.feet import find_feet
from orishell.design import Design
from orishell.design_file import DesignFile
from orishell.design_file.file import check_design
from orishell.families.flat_foldable.mechanism import FlatFoldable
from orishell.motion.quads import grid_corners
from orishell.shell.designed import design_of
from orishell.shell.make import make_shell
from samples import thorough

DOME = {"formula": "sqrt(25 - x**2 - y**2)", "x": [-3, 3], "y": [-3, 3]}
BARREL = {"formula": "sqrt(9 - y**2) + 0.05*x", "x": [-3, 3], "y": [-2.5, 2.5]}
"""A barrel that rises along x, so that nothing of its rim is level as fitted."""


def file_of(surface: dict[str, Any], **pattern: Any) -> DesignFile:
    table = {"rows": 5, "columns": 5, "direction_deg": 0, "fold_deg": 90, **pattern}
    shell = {"family": "flat-foldable", "unit": "m"}
    tables = {"shell": shell, "target": {"surface": surface}, "pattern": table}
    return check_design(tables, Path("x.toml"))


def designed(surface: dict[str, Any], **pattern: Any) -> Design:
    file = file_of(surface, **pattern)
    return design_of(file, file.pattern)


def heights(design: Design) -> np.ndarray:
    mechanism = design.mechanism
    return mechanism.positions(mechanism.target_drive)[..., 2]


def sheet_of(design: Design) -> FlatFoldable:
    assert isinstance(design.mechanism, FlatFoldable)
    return design.mechanism


def test_a_dome_stands_on_a_foot_at_each_corner_and_nothing_is_lower() -> None:
    """To 1e-12 of the diagonal, 100 times what was seen."""
    design = designed(DOME, ground="corners")
    z = heights(design)
    low = z - z.min() < 1e-12 * 8
    for row in (slice(0, 2), slice(-2, None)):
        for column in (slice(0, 2), slice(-2, None)):
            assert low[row, column].any()
    assert not low[2:-2].any()
    assert not low[:, 2:-2].any()
    feet = find_feet(design)
    assert feet is not None
    assert feet.level
    assert set(feet.points) == {(row, column) for row, column in np.argwhere(low).tolist()}
    assert len(feet.columns(design.mechanism)) == 2


def test_two_sides_of_a_barrel_stand_on_the_ground_along_their_whole_length() -> None:
    design = designed(BARREL, ground="level")
    z = heights(design)
    ground = z.min()
    sides = [z[0], z[-1]]
    assert np.abs(np.concatenate(sides) - ground).max() < 1e-12 * 8
    assert (z[1:-1] > ground + 1e-3).all()


@pytest.mark.parametrize(("surface", "ground"), [(DOME, "corners"), (BARREL, "level")])
def test_only_the_border_moves_and_it_stays_planar_and_folds_as_before(
    surface: dict[str, Any], ground: str
) -> None:
    free, cut = designed(surface), designed(surface, ground=ground)
    before, after = sheet_of(free), sheet_of(cut)
    for drive in (0.0, after.target_drive, 0.9 * np.pi):
        places = after.positions(drive)
        assert np.abs(places - before.positions(drive))[1:-1, 1:-1].max() < 1e-12 * 8
        p, q, r, s = np.moveaxis(grid_corners(places).reshape(-1, 4, 3), 1, 0)
        normal = np.cross(q - p, r - p)
        normal /= np.linalg.norm(normal, axis=-1)[:, None]
        assert np.abs(((s - p) * normal).sum(axis=-1)).max() < 1e-12 * 8
    for ours, theirs in zip(
        (after.fold_angles(1.0).row, after.fold_angles(1.0).column),
        (before.fold_angles(1.0).row, before.fold_angles(1.0).column),
        strict=True,
    ):
        assert (ours == theirs).all()


@thorough
def test_the_report_says_how_it_stands_and_the_proof_runs_as_ever() -> None:
    shell = make_shell(file_of(DOME, rows=5, columns=5, ground="corners"))
    said = {row.subject: row.finding for row in shell.report.verdict}
    assert said["feet"].startswith("level on z = 0, on vertices ")
    assert shell.report.feasible
    assert not any("not level" in each for each in shell.report.warnings)
    typed = {
        key: value
        for key, value in shell.report.parameters.items()
        if key.endswith(("_lengths", "_folds_deg", "_angles_deg")) or key in ("sheet", "corners")
    }
    again = file_of(DOME).changed({"target": None, "pattern": {"rows": 5, "columns": 5, **typed}})
    lists = design_of(again, again.pattern).mechanism
    flat = np.sort(np.linalg.norm(np.diff(shell.design.mechanism.positions(0.0), axis=0), axis=-1))
    other = np.sort(np.linalg.norm(np.diff(lists.positions(0.0), axis=0), axis=-1))
    assert flat == pytest.approx(other, rel=1e-9)


def test_a_saddle_whose_corners_stand_high_is_refused_where_it_rises() -> None:
    saddle = {"formula": "0.06*(x**2 - y**2)", "size": [6, 6], "turn_deg": 45}
    with pytest.raises(DesignError) as refused:
        designed(saddle, ground="corners")
    assert refused.value.place.startswith("at vertex ")
    assert refused.value.keys == ("pattern.ground",)
    assert [each.changes for each in refused.value.candidates] == [{"pattern.ground": "free"}]


def test_a_straight_border_does_not_go_with_the_ground() -> None:
    with pytest.raises(InputError, match="no border straight"):
        designed(DOME, ground="corners", border="straight")


def test_feet_that_are_lines_are_rows_as_before() -> None:
    design = designed(BARREL, ground="level")
    feet = find_feet(design)
    assert feet is not None
    assert (feet.rows, feet.points, feet.level) == ((0, 6), (), True)
