"""Columns of flaps beside straight borders: they fold flat exactly at the target."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from accelerations import shares_of_bounds
from mechanisms import (
    TURNED,
    arch_with_flaps,
    flat_foldable,
    miura_net,
    random_net,
    with_flap_columns,
)
from orishell.conventions.errors import DesignError
from orishell.design_file import read_design_file
from orishell.families.flat_foldable.locks.flaps import FlapColumns, with_flaps
from orishell.families.flat_foldable.locks.straight import straight_bordered
from orishell.families.flat_foldable.net import Net
from orishell.families.flat_foldable.pattern import (
    FlatFoldablePattern,
    SheetKind,
    design_flat_foldable,
)
from orishell.locking import find_lock
from orishell.motion import FoldedState, FoldingMotion, measure_fold_angles
from orishell.shell import make_shell
from orishell.shell.steps import MEASURES
from orishell.verification.residuals import measure_residuals
from samples import thorough

Array = np.ndarray
STEP = 1e-25


def sectors_at_flaps(sheet: FlapColumns) -> Array:
    """Sectors right-up, left-up, left-down, right-down (R, 4) beside the right flaps, measured."""
    places = sheet.positions(0.0)[..., :2] @ np.array([1, 1j])
    here = places[1:-1, -2]
    ways = [places[1:-1, -1], places[:-2, -2], places[1:-1, -3], places[2:, -2]]
    return np.stack(
        [
            np.angle((two - here) / (one - here)) % (2 * np.pi)
            for one, two in zip(ways, ways[1:] + ways[:1], strict=True)
        ],
        axis=-1,
    )


@pytest.mark.parametrize("seed", range(5))
def test_vertices_keep_the_condition_of_a_flap_that_closes(seed: int) -> None:
    # Of any developable vertex of four creases, tested by brute force on 2,000 of them: opposite
    # creases keep sin LU sin LD sin^2(left/2) = sin RU sin RD sin^2(right/2).
    sheet = with_flap_columns(random_net(6, 5, seed))
    right_up, left_up, left_down, right_down = np.sin(sectors_at_flaps(sheet)).T
    beside = sheet.bare.fold_angles(sheet.bare.target_drive).row[:, -1]
    needed = left_up * left_down * np.sin(0.5 * beside) ** 2
    np.testing.assert_allclose(right_up * right_down, needed, rtol=1e-12)


def test_large_sheets_close_and_lock_in_every_row() -> None:
    # Lengths to 1e-12, row creases of flaps 180 degrees to 1e-6, measured.
    sheet = with_flap_columns(random_net(30, 30, 1), (0.0, 1.0), **TURNED)
    residuals, assignment = measure_residuals(FoldingMotion(sheet, 9), FoldedState.of(sheet, 0.0))
    assert residuals.panel_length < 1e-12
    assert residuals.planarity < 1e-12
    assert assignment.constant
    closed = np.rad2deg(measure_fold_angles(sheet.positions(sheet.target_drive)).row[:, -1])
    np.testing.assert_allclose(np.abs(closed), 180.0, rtol=0, atol=1e-6)


@pytest.mark.parametrize("stop", [1e-3, 0.1, 0.5])
@pytest.mark.parametrize("ranges", [3, 512])
def test_bounds_hold_with_a_stop_and_beyond_the_target(stop: float, ranges: int) -> None:
    sheet = with_flap_columns(random_net(6, 5, 3), **TURNED).with_stop(stop)
    assert sheet.target_drive < sheet.end_drive
    for each in (sheet, sheet.least_turning):
        shares_of_bounds(each, 9, ranges, each.end_drive)


def test_the_crease_between_sheet_and_flaps_folds_less_than_a_right_angle() -> None:
    # 90 degrees less half of what the border's column would fold by if it went straight on.
    sheet = with_flap_columns(random_net(5, 5, 2))
    border = np.abs(sheet.fold_angles(sheet.target_drive).column[:, -1])
    y = abs(random_net(5, 5, 2).y[-1, 0])
    np.testing.assert_allclose(border, np.pi / 2 - np.arctan(y), rtol=1e-12)


@pytest.mark.parametrize("width", [0.2, 1.0])
@pytest.mark.parametrize("make", [miura_net, lambda: random_net(6, 5, 3)])
def test_flaps_lock_and_nothing_touches_before(make: Callable[[], Net], width: float) -> None:
    sheet = with_flap_columns(make(), (0.0, width))
    design = design_flat_foldable(FlatFoldablePattern(rows=5, columns=5))
    lock = find_lock(replace(design, mechanism=sheet))
    assert lock.first_contact is not None
    assert (lock.cause, lock.early, lock.first_contact.kind) == ("flaps", False, "flap on flap")
    assert lock.first_contact.clear_until == sheet.target_drive * (1 - 1e-6)


@pytest.mark.parametrize("kind", ["miura", "arch", "fan"])
def test_named_sheets_lock(kind: SheetKind) -> None:
    design = design_flat_foldable(FlatFoldablePattern(rows=5, columns=6, sheet=kind, flap="auto"))
    assert len(design.mechanism.flap_columns) == 2
    lock = find_lock(design)
    assert (lock.cause, lock.early) == ("flaps", False)
    bare = design_flat_foldable(FlatFoldablePattern(rows=5, columns=6, sheet=kind))
    assert bare.mechanism.flap_columns == ()
    assert bare.parameters["flap"] == 0


def test_borders_that_are_not_straight_are_refused() -> None:
    with pytest.raises(DesignError, match="straight border"):
        with_flaps(flat_foldable(random_net(5, 5, 1)), 0.2)
    right = with_flaps(flat_foldable(straight_bordered(random_net(5, 5, 1)).net), 0.2)
    assert right.widths == (0.0, 0.2)


def test_flaps_whose_creases_meet_are_refused() -> None:
    sheet = arch_with_flaps()
    widest = min(each.widest(1.0) for each in sheet._borders if each is not None)
    assert np.isfinite(widest)
    replace(sheet, widths=(0.999 * widest, 0.2))
    with pytest.raises(DesignError, match="too wide"):
        replace(sheet, widths=(1.001 * widest, 0.2))


def test_straight_borders_are_those_of_a_column_that_goes_straight_on() -> None:
    net = random_net(6, 5, 7)
    sheet = straight_bordered(net)
    # Marched from its middle it is the same sheet, and its border is straight.
    again = sheet.net.march()
    np.testing.assert_allclose(again.a, sheet.a, rtol=0, atol=1e-13)
    np.testing.assert_allclose(again.columns, sheet.columns, rtol=1e-12)
    places = sheet.flat()[:, :, -1, 0]
    steps = np.diff(places, axis=1)
    turns = steps[0, 1:] * steps[1, :-1] - steps[1, 1:] * steps[0, :-1]
    assert np.abs(turns).max() < 1e-13
    np.testing.assert_allclose(
        np.linalg.norm(steps, axis=0)[1:-1], net.column_lengths[:, 0], rtol=1e-12
    )


def test_straight_borders_have_exact_derivatives() -> None:
    net = random_net(5, 4, 7)
    step = np.zeros_like(net.y)
    step[-1] = 1.0

    def flat(change: complex) -> Array:
        return np.asarray(straight_bordered(replace(net, y=net.y + change * step)).flat())

    h = 1e-6
    exact = flat(1j * STEP).imag / STEP
    np.testing.assert_allclose((flat(h) - flat(-h)).real / (2 * h), exact, rtol=0, atol=1e-8)


@pytest.mark.parametrize(
    ("tables", "cause"),
    [
        (
            "[panel]\nthickness = 0.01\nmembrane = 0.002\n[workshop]\nareal_density = 6\n"
            '[structure]\nmaterial = "birch plywood"\n'
            'supports = [{ at = "feet", kind = "pinned" }]\ncells = 2',
            "flaps",
        ),
        ("", "flaps"),
        ('[deployment]\nflap_attachment = "clipped"\nfrom = "pack"', "crease"),
        pytest.param("[panel]\nthickness = 0.01\nmembrane = 0.002", "flaps", marks=thorough),
    ],
)
def test_shells_with_flaps(tmp_path: Path, tables: str, cause: str) -> None:
    path = tmp_path / "arch.toml"
    path.write_text(
        '[shell]\nfamily = "flat-foldable"\nunit = "m"\n[pattern]\nsheet = "arch"\n'
        f'rows = 3\ncolumns = 4\nflap = "auto"\n{tables}\n'
    )
    shell = make_shell(read_design_file(path), skip=(*MEASURES, "verification", "stock"))
    assert (shell.lock.cause, shell.lock.early) == (cause, False)
    assert shell.lock.clipped_contact is None
    if "panel" in tables:
        # Boards meet at the target: flaps stop short by what their thickness asks for.
        assert 0 < float(str(shell.design.parameters["stop_deg"])) < 45
