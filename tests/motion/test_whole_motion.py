"""The whole motion of sheets without flaps: flat sheet, target, pack.

Every state is a state of the same rigid panels, also beyond the target and where the drive's
closed form changes hands: next to the target and next to the end. What rounding allows is said in
units of the sheet's diagonal; fold angles lose what the rounding of coordinates takes from the
shortest edge.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell import (
    Design,
    OrthodiagonalPattern,
    ParallelRepeatingPattern,
    design_orthodiagonal,
    design_parallel_repeating,
)
from orishell.families.orthodiagonal import Orthodiagonal
from orishell.families.orthodiagonal.columns import SLIM
from orishell.families.parallel_repeating import ParallelRepeating
from orishell.locking import lock_without_clash
from orishell.motion import FoldingMotion, diagonal, measure_fold_angles
from orishell.motion.grid import crease_signs
from samples import THOROUGH
from strategies import Request, graph, orthodiagonal_requests, requests

Sheet = ParallelRepeating | Orthodiagonal
Array = np.ndarray
NEAR = 1e-9
EXAMPLES = 250 if THOROUGH else 15
seeds = st.integers(0, 2**32 - 1)


def without_flaps(request: Request) -> tuple[Design, Sheet]:
    design = request.feasible()
    assert isinstance(design.mechanism, Sheet)
    sheet = replace(design.mechanism, flaps=(0.0, 0.0))
    return replace(design, mechanism=sheet), sheet


def drives_of(sheet: Sheet, seed: int) -> Array:
    """The target, near it, anywhere, at the end and ever nearer to it; the target is the first."""
    random = np.random.default_rng(seed)
    target, end = sheet.target_drive, sheet.end_drive
    near = target * (1 + NEAR * np.append(random.uniform(-1, 1, 4), [-1, 1]))
    ending = end * (1 - 10.0 ** -np.arange(1, 16))
    drives = np.concatenate([[target], near, random.uniform(0, end, 6), [end], ending])
    return np.asarray(np.minimum(drives, end))


def panel_distances(positions: Array) -> Array:
    """The six distances of the corners of every panel (..., 6)."""
    rows, columns = positions.shape[-3] - 1, positions.shape[-2] - 1
    corners = [positions[..., i : i + rows, j : j + columns, :] for i, j in np.ndindex(2, 2)]
    pairs = [np.linalg.norm(a - b, axis=-1) for a, b in combinations(corners, 2)]
    return np.stack(pairs, axis=-1)


def row_and_column(sheet: Sheet, drives: Array) -> Iterator[tuple[Array, Array]]:
    """Fold angles from the closed form and as measured, if there are any."""
    angles = sheet.fold_angles(drives)
    measured = measure_fold_angles(sheet.positions(drives))
    for expected, found in ((angles.row, measured.row), (angles.column, measured.column)):
        if expected.size:
            yield expected, found


def require_whole_motion(sheet: Sheet, seed: int) -> None:
    drives = drives_of(sheet, seed)
    flat, states = sheet.positions(0.0), sheet.positions(drives)
    size = diagonal(flat)

    # Panels are rigid.
    assert np.abs(panel_distances(states) - panel_distances(flat)).max() < 1e-14 * size

    # Creases fold as the closed form says.
    for expected, found in row_and_column(sheet, drives):
        difference = (expected - found + np.pi) % (2 * np.pi) - np.pi
        assert np.abs(difference).max() < 1e-11

    # The target state is that of the sheet with flaps, whose motion ends there.
    flapped = replace(sheet, flaps=(0.3 * size, 0.2 * size))
    assert flapped.target_drive == flapped.end_drive == np.pi
    target = flapped.positions(np.pi)[:, 1:-1]
    assert np.abs(states[0] - target).max() < 1e-13 * size

    # No jump at the target: both sides are as far from it as the motion is fast there, and on
    # opposite sides of it.
    h = NEAR * sheet.target_drive
    before, after = (np.abs(states[k] - states[0]).max() for k in (5, 6))
    wide = sheet.positions(sheet.target_drive + 1e2 * h * np.array([-1.0, 1.0]))
    speed = np.abs(wide[1] - wide[0]).max() / (2e2 * h)
    for step in (before, after):
        assert step == pytest.approx(speed * h, rel=1e-3, abs=1e-14 * size)
    assert np.abs(states[5] + states[6] - 2 * states[0]).max() < 1e-3 * speed * h + 1e-14 * size


def require_signs_of_the_target(sheet: Sheet, drives: Array) -> None:
    """Mountains and valleys stay so; what is as good as unfolded at the target never turns over."""
    signs = crease_signs(sheet.fold_angles(drives))
    target = crease_signs(sheet.fold_angles(sheet.target_drive))
    np.testing.assert_array_equal(signs.row, np.broadcast_to(target.row, signs.row.shape))
    assert (signs.column * target.column >= 0).all()
    assert (signs.column.max(axis=0, initial=0) * signs.column.min(axis=0, initial=0) >= 0).all()
    assert (target.row != 0).all()


def require_growing_fold_angles(sheet: Sheet, drives: Array) -> Array:
    """The largest fold angle grows from 0 to pi; it is returned for every drive.

    At the end to 1e-10, or to what it grows by from as near to the end as a pack is taken: SLIM.
    """
    drives = np.append(0.0, drives)
    largest = np.abs(sheet.fold_angles(drives).row).max(axis=(-2, -1))
    order = np.argsort(drives)
    apart = np.diff(drives[order]) > 1e-10
    assert (np.diff(largest[order])[apart] > 0).all()
    assert largest[0] == 0
    before = sheet.end_drive * np.array([1 - 2e-8, 1 - 1e-8])
    speed = np.ptp(np.abs(sheet.fold_angles(before).row).max(axis=(1, 2))) / np.ptp(before)
    assert largest[order][-1] == pytest.approx(np.pi, abs=max(1e-10, 2 * SLIM * speed))
    return np.asarray(largest[1:])


@settings(max_examples=EXAMPLES)
@given(requests(), seeds)
def test_any_parallel_repeating_sheet_without_flaps(request: Request, seed: int) -> None:
    design, sheet = without_flaps(request)
    require_whole_motion(sheet, seed)
    # The drive is the largest fold angle, that of the row creases in the tightest panel column.
    drives = drives_of(sheet, seed)
    require_signs_of_the_target(sheet, drives)
    largest = require_growing_fold_angles(sheet, drives)
    np.testing.assert_allclose(largest, drives, rtol=0, atol=1e-14)
    assert lock_without_clash(design).cause == "crease"


@settings(max_examples=EXAMPLES)
@given(orthodiagonal_requests(), seeds)
def test_any_orthodiagonal_sheet_without_flaps(request: Request, seed: int) -> None:
    design, sheet = without_flaps(request)
    assert isinstance(sheet, Orthodiagonal)
    require_whole_motion(sheet, seed)
    drives = drives_of(sheet, seed)
    require_signs_of_the_target(sheet, drives)
    require_growing_fold_angles(sheet, drives)
    # Half the drive is the lean of the tightest panel column, but for how near the end is taken.
    lean, rounding = measure_lean(sheet, drives)
    assert np.abs(lean - drives / 2).max() < SLIM + rounding
    assert lock_without_clash(design).cause == "crease"


def measure_lean(sheet: Orthodiagonal, drives: Array) -> tuple[Array, float]:
    """The angles with the tangent kappa N(flat)/N of the tightest panel column, from positions.

    N is the distance of neighbouring columns along n. Kappa is in the angle psi between the two
    edges at the middle row: cot(psi/2) = kappa cot(beta/2). Also returned is how much rounding
    can turn them (radians): what it moves corners by, across the shortest edge or panel.
    """
    normal = 1j * np.exp(-1j * sheet.heading)
    axis = np.array([normal.real, normal.imag, 0.0])
    middle = len(sheet.angles) // 2
    flat = np.diff(sheet.positions(0.0)[middle + 1] @ axis)
    states = sheet.positions(drives)
    steps = np.diff(states[:, middle + 1] @ axis, axis=-1)
    up, down = (states[:, middle + k, 0] - states[:, middle + 1, 0] for k in (0, 2))
    shortest = min(np.linalg.norm(arm[0]) for arm in (up, down))
    up, down = (arm / np.linalg.norm(arm, axis=-1, keepdims=True) for arm in (up, down))
    half = np.arctan2(*(np.linalg.norm(arm, axis=-1) for arm in (up + down, up - down)))
    kappa = np.tan(half) * np.tan(sheet.angles[middle] / 2)
    # The tightest column has closed the most, in every state.
    lean = np.arctan2(kappa, (steps / flat).min(axis=-1))
    rounding = 100 * np.finfo(float).eps * np.abs(states).max() / min(shortest, flat.min())
    return lean, float(rounding)


@pytest.mark.parametrize(
    "g",
    ["0*x", "0.1*x + 1", "1e-13*x**3", "1e-11*sin(3*x)", "1e-9*sin(x)", "1e-7*x**2", "1e-3*sin(x)"],
)
def test_rows_that_are_straight_or_nearly_so(g: str) -> None:
    # What a row takes across f's plane decides where the pack is, however small it is beside 1.
    f = graph("-x**2", -1, 1)
    design = design_orthodiagonal(
        f, graph(g, 0, 4), OrthodiagonalPattern(rows=9, columns=7, depth=0.12, flap=0)
    )
    sheet = design.mechanism
    assert isinstance(sheet, Orthodiagonal)
    require_whole_motion(sheet, 0)
    # Column creases that are as good as unfolded at the target may fold near the pack: not back.
    angles = sheet.fold_angles(np.linspace(0, np.pi, 50)).column
    assert (angles * sheet.fold_angles(3.1).column >= -1e-15).all()
    lock = lock_without_clash(design)
    assert (lock.cause, lock.drive) == ("crease", np.pi)


@pytest.mark.parametrize("columns", [5, 12])
@pytest.mark.parametrize(
    "g", ["0*x", "1e-7*x**2", "1e-6*sqrt(x**2 + 0.01)", "1e-5*sin(3*x)", "1e-4*x**3", "1e-2*x**2"]
)
def test_panel_columns_that_fold_flat_nearly_together(g: str, columns: int) -> None:
    # At the end row creases in all panel columns are nearly closed: what differs counts.
    design = design_parallel_repeating(
        graph("0*x", -1, 1),
        graph(g, -3, 3),
        ParallelRepeatingPattern(rows=1, columns=columns, xi_deg=np.rad2deg(1.4), flap=0),
    )
    sheet = design.mechanism
    assert isinstance(sheet, ParallelRepeating)
    flat, states = sheet.positions(0.0), sheet.positions(drives_of(sheet, 0))
    errors = panel_distances(states) - panel_distances(flat)
    assert np.abs(errors).max() < 1e-14 * diagonal(flat)


def test_straight_rows_close_with_the_zigzags_of_the_columns() -> None:
    # A row of one panel column each beside the other: kappa = tan(rho/2) (text of the mechanism),
    # and the angles psi between the edges of a column with cot(psi/2) = kappa cot(beta/2).
    f = graph("-x**2", -1, 1)
    sheet = design_orthodiagonal(
        f,
        graph("0*x", 0, 4),
        OrthodiagonalPattern(
            rows=9, columns=7, depth=0.12, heading_deg=np.rad2deg(np.pi / 2), flap=0
        ),
    ).mechanism
    assert isinstance(sheet, Orthodiagonal)
    assert sheet.target_drive == pytest.approx(np.pi / 2, abs=1e-15)
    for drive in (0.3, np.pi / 2, 2.5, 3.1):
        edges = np.diff(sheet.positions(drive)[:, 0], axis=0)
        edges /= np.linalg.norm(edges, axis=-1, keepdims=True)
        turned = 2 * np.arcsin(0.5 * np.linalg.norm(np.diff(edges, axis=0), axis=-1))
        expected = 2 * np.arctan(np.tan(drive / 2) / np.tan(sheet.angles / 2))
        np.testing.assert_allclose(turned, expected, rtol=0, atol=1e-13)
    edges = np.diff(sheet.positions(np.pi)[:, 0], axis=0)
    edges /= np.linalg.norm(edges, axis=-1, keepdims=True)
    np.testing.assert_allclose(edges[1:], -edges[:-1], rtol=0, atol=1e-11)


@pytest.mark.parametrize("frames", [3, 4, 25])
def test_states_from_the_pack_over_the_target_to_the_flat_sheet(frames: int) -> None:
    f, g = graph("-x**2", -1, 1), graph("0.25*sin(pi*x/2)", 0, 4)
    sheet = design_orthodiagonal(
        f, g, OrthodiagonalPattern(rows=9, columns=13, depth=0.12, flap=0)
    ).mechanism
    for pack in (sheet.end_drive, 0.5 * (sheet.target_drive + sheet.end_drive)):
        motion = FoldingMotion(sheet, frames, pack)
        assert len(motion.drives) == frames
        assert (np.diff(motion.drives) < 0).all()
        wanted = {"pack": pack, "target": sheet.target_drive, "flat": 0.0}
        assert {name: motion.drives[at] for name, at in motion.named.items()} == wanted
