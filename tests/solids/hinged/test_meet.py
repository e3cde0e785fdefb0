"""Lengths with which whole boards meet the target: no angle changes, and no others come nearer."""

from __future__ import annotations

import numpy as np
import pytest

from flat_foldables import random_sheet
from mechanisms import parallel, upright
from orishell.design import PanelSpec
from orishell.motion import Mechanism, diagonal
from orishell.motion.hinges import FreeLengths, Hinges
from orishell.motion.mechanism import panel_normals
from orishell.motion.quads import dots, grid_corners
from orishell.numerics.arrays import Array
from orishell.solids.hinged import board_offsets, find_hinges, meet_target
from samples import thorough


def hinged(sheet: Mechanism, share: float = 1e-3) -> Hinges:
    size = diagonal(sheet.positions(0.0))
    return find_hinges(sheet, PanelSpec(thickness=share * size, construction="hinged"))


def shell(sheet: Mechanism) -> Array:
    return sheet.positions(sheet.target_drive)


def rms(values: Array) -> float:
    return float(np.sqrt((values**2).mean()))


@pytest.mark.parametrize(
    "seed", [*range(12), *(pytest.param(seed, marks=thorough) for seed in range(12, 100))]
)
def test_no_angle_changes_and_boards_come_nearer(seed: int) -> None:
    """Fold angles to 1e-9. In the median of 100 sheets a third of the offset is left."""
    sheet = random_sheet(seed)
    hinges, size = hinged(sheet), diagonal(sheet.positions(0.0))
    fitted, placed = meet_target(sheet, hinges)
    for share in (0.2, 0.7, 0.95):
        drive = share * sheet.end_drive
        before, after = sheet.fold_angles(drive), fitted.fold_angles(drive)
        assert np.abs(before.row - after.row).max() < 1e-9
        assert np.abs(before.column - after.column).max() < 1e-9
        assert placed.gap(fitted.positions(drive)) < 1e-12 * size
    meant = shell(sheet)
    left = rms(board_offsets(placed, shell(fitted), meant))
    assert left < rms(board_offsets(hinges, meant, meant))


@pytest.mark.parametrize(
    "sheet",
    [
        parallel(9, 11, plane="bisector", xi_deg=50, flap=0.0),
        upright(9, 13, row="zigzag", depth=0.1, flap=0.0).straightened(),
    ],
    ids=["parallel repeating", "orthodiagonal"],
)
def test_boards_of_sweeps_lie_in_the_planes_of_the_panels(sheet: Mechanism) -> None:
    """To a thousandth of how far they lie beside the sheet without a fit."""
    hinges, meant = hinged(sheet), shell(sheet)
    fitted, placed = meet_target(sheet, hinges)
    apart = placed.boards(shell(fitted)) - grid_corners(meant)
    off = np.abs(dots(apart, panel_normals(meant)[..., None, :])).max()
    assert off < 1e-3 * board_offsets(hinges, meant).max()


@pytest.mark.parametrize("seed", range(4))
def test_the_fit_is_done_at_once(seed: int) -> None:
    """Corners are affine in the lengths: the lengths that were found are those found from them."""
    sheet = random_sheet(seed)
    hinges, meant = hinged(sheet), shell(sheet)
    fitted, placed = meet_target(sheet, hinges)
    assert isinstance(fitted, FreeLengths)
    again, replaced = meet_target(fitted, placed, meant)
    assert isinstance(again, FreeLengths)
    for name, lengths in fitted.free_lengths().items():
        np.testing.assert_allclose(again.free_lengths()[name], lengths, rtol=1e-7)
    assert np.abs(replaced.place - placed.place).max() < 1e-7 * diagonal(meant)


def test_no_edge_loses_more_than_half_of_its_length() -> None:
    """Boards so thick that a fit would turn edges round are left as near as half of it brings."""
    sheet = upright(9, 13, row="zigzag", depth=0.1, flap=0.0).straightened()
    fitted, _ = meet_target(sheet, hinged(sheet, 0.02))
    for axis in (0, 1):
        before, after = (np.diff(each.positions(0.0), axis=axis) for each in (sheet, fitted))
        shares = dots(before, after) / dots(before, before)
        assert shares.min() > 0.5 - 1e-9
