"""flap = 0: the columns between the flaps, as they are with flaps, and free to close further."""

from dataclasses import astuple, replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.conventions.errors import DesignError
from orishell.design import Design
from orishell.families.orthodiagonal import (
    Orthodiagonal,
    OrthodiagonalPattern,
    design_orthodiagonal,
)
from orishell.families.parallel_repeating import (
    ParallelRepeating,
    ParallelRepeatingPattern,
    design_parallel_repeating,
)
from orishell.locking import find_lock
from orishell.motion import FoldingMotion, diagonal
from orishell.motion.grid import Grid
from orishell.verification.residuals import AssignmentCheck, measure_residuals
from samples import examples
from strategies import (
    Request,
    graph,
    orthodiagonal_requests,
    requests,
)

PARABOLA = graph("-x**2", -1, 1)
DRIVES = (0.0, 1.0, np.pi)
Sheet = ParallelRepeating | Orthodiagonal


def parallel(**options: Any) -> Design:
    g = graph("5*sin(pi*x/10)", 0, 20)
    return design_parallel_repeating(
        PARABOLA,
        g,
        ParallelRepeatingPattern(
            rows=9, columns=11, xi_deg=50, flap_side=["start", "end"], **options
        ),
    )


def orthodiagonal(**options: Any) -> Design:
    g = graph("0.25*sin(pi*x/2)", 0, 4)
    return design_orthodiagonal(
        PARABOLA, g, OrthodiagonalPattern(rows=9, columns=13, depth=0.12, **options)
    )


def drive_without_flaps(bare: Sheet, drive: float) -> float:
    """Where a sheet without flaps is as far as one with flaps is at a drive (radians).

    As far as kappa says, from which all angles follow (text of the mechanisms): kappa is
    sin(drive/2) with flaps and what the bare drive is solved for without.
    """
    kappa, q = np.sin(drive / 2), np.cos(drive / 2)
    rest = bare._columns.rest
    turn = 1.0 if isinstance(bare, ParallelRepeating) else np.sqrt((1 - rest) * (1 + rest))
    return float(2 * np.arctan2(kappa, np.hypot(rest, q * turn)))


def levelled(bare: Sheet, drive: float, bare_drive: float) -> np.ndarray:
    """Positions without flaps, turned about n as the sheet with flaps is at its drive.

    An orthodiagonal sheet turns evenly with the drive, from level to its tilt at the target, about
    the centroid of its middle row, weighted by length.
    """
    positions = bare.positions(bare_drive)
    if isinstance(bare, ParallelRepeating):
        return positions
    angle = bare.tilt * (drive / np.pi - bare_drive / bare.target_drive)
    row = positions[len(positions) // 2]
    middle, length = 0.5 * (row[1:] + row[:-1]), np.abs(np.diff(bare.points))
    centroid = (middle * length[:, None]).sum(axis=0) / length.sum()
    plan = np.exp(-1j * bare.heading)
    t, up = np.array([plan.real, plan.imag, 0.0]), np.array([0.0, 0.0, 1.0])
    arm = positions - centroid
    along, height = arm @ t, arm @ up
    turned = (along + 1j * height) * np.exp(1j * angle)
    return np.asarray(
        positions + (turned.real - along)[..., None] * t + (turned.imag - height)[..., None] * up
    )


def require_inner_columns(bare: Sheet, flapped: Sheet, drives: tuple[float, ...]) -> None:
    """The same shapes in the same places with the same fold angles, but for rounding."""
    rows, columns = flapped.grid.rows, flapped.grid.columns - 2
    assert bare.grid == Grid(rows, columns)
    assert bare.inner_columns == slice(0, columns)
    assert flapped.inner_columns == slice(1, columns + 1)
    assert (bare.flap_columns, flapped.flap_columns) == ((), (0, columns))
    assert flapped.target_drive == flapped.end_drive == bare.end_drive == np.pi
    for drive in drives:
        bare_drive = drive_without_flaps(bare, drive)
        expected = flapped.positions(drive)[:, 1:-1]
        size = diagonal(bare.positions(0.0)) + np.abs(expected).max()
        found = levelled(bare, drive, bare_drive)
        assert np.abs(found - expected).max() < 1e-13 * size
        angles, wanted = bare.fold_angles(bare_drive), flapped.fold_angles(drive)
        np.testing.assert_allclose(angles.row, wanted.row[:, 1:-1], rtol=0, atol=1e-13)
        np.testing.assert_allclose(angles.column, wanted.column[:, 1:-1], rtol=0, atol=1e-13)
    at_target = bare.positions(bare.target_drive) - flapped.positions(np.pi)[:, 1:-1]
    assert np.abs(at_target).max() < 1e-13 * size


@settings(max_examples=examples(60))
@given(requests(), st.floats(0.0, np.pi))
def test_parallel_columns_are_as_they_are_with_flaps(request: Request, drive: float) -> None:
    mechanism = request.feasible().mechanism
    assert isinstance(mechanism, ParallelRepeating)
    require_inner_columns(mechanism.with_flaps(0), mechanism.with_flaps(0.3), (0.0, drive, np.pi))


@settings(max_examples=examples(60))
@given(orthodiagonal_requests(), st.floats(0.0, np.pi))
def test_orthodiagonal_columns_are_as_they_are_with_flaps(request: Request, drive: float) -> None:
    mechanism = request.feasible().mechanism
    assert isinstance(mechanism, Orthodiagonal)
    bare, flapped = (replace(mechanism, flaps=(width, width)) for width in (0.0, 0.3))
    require_inner_columns(bare, flapped, (0.0, drive, np.pi))


@pytest.mark.parametrize("make", [parallel, orthodiagonal])
def test_a_design_without_flaps_does_not_lock_at_its_target(make: Any) -> None:
    bare, flapped = make(flap=0), make(flap=0.15)
    lock = find_lock(bare)
    assert lock.cause in {"clash", "crease"}
    assert lock.drive is not None
    assert lock.drive > lock.target_drive == bare.mechanism.target_drive
    assert find_lock(flapped).cause == "flaps"
    assert bare.parameters["flap"] == 0
    assert flapped.warnings == ()
    (warning,) = bare.warnings
    assert warning.endswith("keeps the shell from closing beyond its target")
    require_inner_columns(bare.mechanism, flapped.mechanism, DRIVES)


def test_ends_are_trimmed_for_the_columns_that_there_are() -> None:
    # Wide flaps are cut off so that the shell ends level, and wider ones are refused.
    assert orthodiagonal(flap=0.35).parameters["ends"] == ["level", "level"]
    assert orthodiagonal(flap=0).parameters["ends"] == ["level", "level"]
    with pytest.raises(DesignError, match="flaps are too wide"):
        orthodiagonal(flap=0.45)


@pytest.mark.parametrize(("rows", "columns"), [(1, 2), (1, 11), (9, 2), (3, 3)])
def test_smallest_sheets(rows: int, columns: int) -> None:
    for design in (
        design_parallel_repeating(
            PARABOLA.scaled(0.2),
            graph("x**2/40", 0, 10),
            ParallelRepeatingPattern(rows=rows, columns=columns, flap=0),
        ),
        design_orthodiagonal(
            PARABOLA,
            graph("0.02*x**2", 0, 1),
            OrthodiagonalPattern(rows=rows, columns=columns, flap=0),
        ),
    ):
        assert design.mechanism.grid == Grid(rows + 2, columns)
        motion = FoldingMotion(design.mechanism, 3)
        residuals, assignment = measure_residuals(motion, motion.flat)
        assert max(astuple(residuals)) < 1e-12
        assert assignment == AssignmentCheck(constant=True, maekawa=True)
        for axis in (0, 1):
            edges = np.diff(motion.target.positions, axis=axis)
            assert np.linalg.norm(edges, axis=-1).min() > 0.01
