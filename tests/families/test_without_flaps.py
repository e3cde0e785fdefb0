"""flap = 0: the columns between the flaps, as they are with flaps, and nothing that locks them."""

from dataclasses import astuple, replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.design import Design
from orishell.errors import DesignError
from orishell.families.orthodiagonal import Orthodiagonal, design_orthodiagonal
from orishell.families.parallel_repeating import ParallelRepeating, design_parallel_repeating
from orishell.locking import find_lock
from orishell.motion import FoldingMotion
from orishell.sheet.grid import Grid
from orishell.verification.residuals import AssignmentCheck, measure_residuals
from strategies import (
    Request,
    graph,
    orthodiagonal_requests,
    requests,
)

PARABOLA = graph("-x**2", -1, 1)
DRIVES = (0.0, 1.0, np.pi)


def parallel(**options: Any) -> Design:
    g = graph("5*sin(pi*x/10)", 0, 20)
    return design_parallel_repeating(
        PARABOLA, g, rows=9, columns=11, xi=np.deg2rad(50), flap_sides=("start", "end"), **options
    )


def orthodiagonal(**options: Any) -> Design:
    g = graph("0.25*sin(pi*x/2)", 0, 4)
    return design_orthodiagonal(PARABOLA, g, rows=9, columns=13, depth=0.12, **options)


def require_inner_columns(
    bare: ParallelRepeating | Orthodiagonal,
    flapped: ParallelRepeating | Orthodiagonal,
    drives: tuple[float, ...],
) -> None:
    """Placement and angles are bit for bit the same."""
    rows, columns = flapped.grid.rows, flapped.grid.columns - 2
    assert bare.grid == Grid(rows, columns)
    assert bare.inner_columns == slice(0, columns)
    assert flapped.inner_columns == slice(1, columns + 1)
    for drive in drives:
        np.testing.assert_array_equal(bare.positions(drive), flapped.positions(drive)[:, 1:-1])
        angles, expected = bare.fold_angles(drive), flapped.fold_angles(drive)
        np.testing.assert_array_equal(angles.row, expected.row[:, 1:-1])
        np.testing.assert_array_equal(angles.column, expected.column[:, 1:-1])


@settings(max_examples=60)
@given(requests(), st.floats(0.0, np.pi))
def test_parallel_columns_are_as_they_are_with_flaps(request: Request, drive: float) -> None:
    mechanism = request.feasible().mechanism
    assert isinstance(mechanism, ParallelRepeating)
    require_inner_columns(mechanism.with_flaps(0), mechanism.with_flaps(0.3), (0.0, drive, np.pi))


@settings(max_examples=60)
@given(orthodiagonal_requests(), st.floats(0.0, np.pi))
def test_orthodiagonal_columns_are_as_they_are_with_flaps(request: Request, drive: float) -> None:
    mechanism = request.feasible().mechanism
    assert isinstance(mechanism, Orthodiagonal)
    bare, flapped = (replace(mechanism, flaps=(width, width)) for width in (0.0, 0.3))
    require_inner_columns(bare, flapped, (0.0, drive, np.pi))


@pytest.mark.parametrize("make", [parallel, orthodiagonal])
def test_a_design_without_flaps_does_not_lock(make: Any) -> None:
    bare, flapped = make(flap=0), make(flap=0.15)
    assert (find_lock(bare).cause, find_lock(flapped).cause) == (None, "flaps")
    assert bare.parameters["flap"] == 0
    assert flapped.warnings == ()
    (warning,) = bare.warnings
    assert warning.endswith("the shell does not lock")
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
            PARABOLA.scaled(0.2), graph("x**2/40", 0, 10), rows=rows, columns=columns, flap=0
        ),
        design_orthodiagonal(
            PARABOLA, graph("0.02*x**2", 0, 1), rows=rows, columns=columns, flap=0
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
