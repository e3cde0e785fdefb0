"""Flaps on any border, slit from row to row: every row folds flat exactly at the target."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest

from mechanisms import TURNED, flat_foldable, random_net
from orishell.design import Design
from orishell.design.piece import Piece
from orishell.design_file import check_design
from orishell.document import Document
from orishell.document.from_design import document_of_design
from orishell.families.flat_foldable.fit.conditions import Conditions
from orishell.families.flat_foldable.fit.design import mechanism_of
from orishell.families.flat_foldable.fit.initial_guesses import Task, fit_sheet
from orishell.families.flat_foldable.locks.slit import SlitFlaps
from orishell.families.flat_foldable.mechanism import FlatFoldable
from orishell.families.flat_foldable.pattern import FlatFoldablePattern, design_flat_foldable
from orishell.io import document_of_fold, read_fold, write_fold
from orishell.locking import end_motion, find_lock
from orishell.locking.result import Lock
from orishell.motion import area_of, drive_at_fold
from orishell.motion.quads import signed_areas
from orishell.shell.make import make_shell
from orishell.structure.flaps import hung_area, kept_apart
from orishell.verification import inspect_fold
from orishell.verification.residuals import measure_with_flaps
from orishell.workshop import Workshop
from orishell.workshop.assembly import laid_flat
from orishell.workshop.cut_parts import whole_sheet
from orishell.workshop.layout import lay_out
from samples import THOROUGH, led_by, thorough

Array = np.ndarray
RANGES = 512
SURFACES: dict[str, Callable[[Array, Array], Array]] = {
    "cap": lambda x, y: np.sqrt(1 - x * x - y * y),
    "saddle": lambda x, y: 0.5 * (x * x - y * y),
    "ellipsoid": lambda x, y: 1.3 * np.sqrt(1 - (x / 1.5) ** 2 - y * y),
    "hypar": lambda x, y: x * y,
}


def sheet_of(seed: int, widths: tuple[float, float] = (0.2, 0.3), stop: float = 0.0) -> SlitFlaps:
    return SlitFlaps(flat_foldable(random_net(6, 5, seed), **TURNED), widths, stop)


def lock_of(sheet: SlitFlaps) -> Lock:
    design = design_flat_foldable(FlatFoldablePattern(rows=5, columns=5))
    return find_lock(replace(design, mechanism=sheet))


def changes_of_lengths(sheet: SlitFlaps, drives: Array) -> float:
    """How much sides and diagonals of panels change at most from the flat sheet, by themselves."""
    faces = sheet.layout.faces
    now, flat = sheet.points(drives)[:, faces], sheet.points(0.0)[faces]
    return max(
        float(
            np.abs(
                np.linalg.norm(now[:, :, i] - now[:, :, j], axis=-1)
                / np.linalg.norm(flat[:, i] - flat[:, j], axis=-1)
                - 1
            ).max()
        )
        for i, j in combinations(range(4), 2)
    )


def angles_between_flaps(sheet: SlitFlaps, drive: float) -> Array:
    """Fold angles (K,) between two flaps, measured (degrees)."""
    first, second = (sheet.points(drive)[sheet.layout.faces[each]] for each in sheet.layout.pairs.T)
    u, v = (np.cross(each[:, 2] - each[:, 0], each[:, 3] - each[:, 1]) for each in (first, second))
    sine = np.linalg.norm(np.cross(u, v), axis=-1)
    return np.asarray(np.rad2deg(np.arctan2(sine, (u * v).sum(axis=-1))))


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("stop", [0.0, 0.1])
def test_flaps_are_rigid_and_close_at_the_target(seed: int, stop: float) -> None:
    sheet = sheet_of(seed, stop=stop)
    drives = sheet.end_drive * np.append(np.linspace(0, 1, 30), 1 - 1e-9)
    assert changes_of_lengths(sheet, drives) < 1e-12
    at_target = angles_between_flaps(sheet, sheet.target_drive)
    assert at_target.max() == pytest.approx(180 - 2 * np.rad2deg(stop), abs=1e-6)
    if not stop:
        np.testing.assert_allclose(at_target, 180.0, rtol=0, atol=1e-6)
    closed = np.rad2deg(np.abs(sheet.flap_folds(sheet.target_drive)))
    np.testing.assert_allclose(at_target, closed, rtol=0, atol=1e-5)
    # The sheet meets its target as without flaps.
    bare = sheet.bare
    met = sheet.positions(sheet.target_drive) - bare.positions(bare.target_drive)
    assert np.abs(met).max() < 1e-13


def test_large_sheets_close() -> None:
    sheet = SlitFlaps(flat_foldable(random_net(30, 30, 1)), (0.2, 0.2))
    assert changes_of_lengths(sheet, np.linspace(0, np.pi, 9)) < 1e-12


def test_flaps_lie_flat_and_count_counter_clockwise() -> None:
    sheet = sheet_of(1)
    corners = sheet.points(0.0)[sheet.layout.faces]
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    assert (normals[:, 2] > 0).all()
    assert np.abs(corners[..., 2] - corners[0, 0, 2]).max() < 1e-14


@pytest.mark.parametrize("number", [0, 20, 250, 400, 511])
def test_vectors_swing_no_faster_than_the_sums_of_bounds(number: int) -> None:
    # Second differences in a range of the drive, between vertices of every two panels.
    for sheet in (sheet_of(3), sheet_of(3).least_turning, sheet_of(3, stop=0.1)):
        h = 0.5 * sheet.end_drive / RANGES
        middle = (number + 0.5) * sheet.end_drive / RANGES
        ends = np.array([middle - h]), np.array([middle + h])
        along, down = (np.append(0, np.cumsum(each)) for each in sheet.edge_accelerations(*ends))
        before, now, after = (sheet.points(middle + step) for step in (-h, 0, h))
        layout = sheet.layout
        swing = ((before - now) + (after - now))[layout.faces] / h**2
        low = np.minimum(layout.first[:, None], layout.first[None])
        high = np.maximum(layout.last[:, None], layout.last[None])
        bound = down[high[..., 0]] - down[low[..., 0]] + along[high[..., 1]] - along[low[..., 1]]
        difference = swing[:, None, :, None] - swing[None, :, None]
        true = np.linalg.norm(difference, axis=-1).max(axis=(2, 3))
        assert (true <= bound * (1 + 1e-9) + 1e-8).all()


@pytest.mark.parametrize(
    ("seed", "stop"),
    led_by([(0, 0.0), (1, 0.1), (2, 0.0), (0, 0.1), (1, 0.0), (2, 0.1)], 3),
)
def test_flaps_lock_and_nothing_touches_before(seed: int, stop: float) -> None:
    sheet = sheet_of(seed, stop=stop)
    lock = lock_of(sheet)
    assert lock.first_contact is not None
    assert (lock.cause, lock.early, lock.first_contact.kind) == ("flaps", False, "flap on flap")
    assert lock.drive == sheet.target_drive
    # Two flaps of one row, beside the sheet.
    (upper, column), (lower, other) = lock.first_contact.panels
    assert column == other
    assert column in (-1, sheet.grid.columns - 1)
    assert (upper % 2, lower) == (0, upper + 1)


def fitted(name: str, count: int) -> FlatFoldable:
    """A sheet over the square of half side 0.5, or of 0.55 x 0.37."""
    wide, deep = (0.55, 0.37) if name == "ellipsoid" else (0.5, 0.5)
    x, y = np.meshgrid(np.linspace(-wide, wide, 49), np.linspace(deep, -deep, 49))
    z, h = SURFACES[name], 1e-6
    slopes = (z(x + h, y) - z(x - h, y)) / (2 * h), (z(x, y + h) - z(x, y - h)) / (2 * h)
    normals = np.stack([-slopes[0], -slopes[1], np.ones_like(x)], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    piece = Piece.of_lattice(np.stack([x, y, z(x, y)], axis=-1), normals)
    fit = fit_sheet(Task(piece, count, count, Conditions(10.0)), direction=0, folded=1.6)
    assert fit is not None
    return mechanism_of(fit)


WIDTH = 0.15
"""Of flaps by the median edge of the border: of the fitted shells the widest is 0.16 to 0.39."""


@pytest.mark.slow
@pytest.mark.parametrize("name", led_by(SURFACES))
def test_fitted_shells_lock(name: str) -> None:
    bare = fitted(name, 9 if THOROUGH else 6)
    edges = np.linalg.norm(np.diff(bare.positions(0.0), axis=0), axis=-1)
    width = WIDTH * float(np.median(edges))
    sheet = SlitFlaps(bare, (width, width))
    drives = np.append(np.linspace(0, np.pi, 30), np.pi * (1 - 1e-9))
    assert changes_of_lengths(sheet, drives) < 1e-12
    at_target = angles_between_flaps(sheet, sheet.target_drive)
    np.testing.assert_allclose(at_target, 180.0, rtol=0, atol=1e-6)
    lock = lock_of(sheet)
    assert (lock.cause, lock.early) == ("flaps", False)


@pytest.mark.slow
@thorough
def test_width_is_found_by_the_proof() -> None:
    bare = fitted("saddle", 9)
    made = replace(design_flat_foldable(FlatFoldablePattern(rows=5, columns=5)), mechanism=bare)

    def of_width(width: float) -> Design:
        sheet = SlitFlaps(bare, (width, width))
        return replace(made, mechanism=sheet, parameters={"flap": width})

    edge = float(np.median(np.linalg.norm(np.diff(bare.positions(0.0), axis=0), axis=-1)))
    design, lock = end_motion(of_width(edge), narrower=of_width)
    width = design.flap
    assert WIDTH * edge < width < edge
    assert (lock.cause, lock.early) == ("flaps", False)
    assert find_lock(of_width(1.01 * width)).early


def test_hinges_that_stop_end_the_motion_before() -> None:
    sheet = sheet_of(2)
    end = drive_at_fold(sheet, np.deg2rad(170))
    folds = np.abs(sheet.flap_folds(np.array([0.999 * end, 1.001 * end]))).max(axis=1)
    assert folds[0] < np.deg2rad(170) < folds[1]


def written(sheet: SlitFlaps) -> Document:
    return document_of_design(
        replace(design_flat_foldable(FlatFoldablePattern(rows=5, columns=5)), mechanism=sheet)
    )


@pytest.mark.parametrize("stop", [0.0, 0.1])
def test_files_have_flaps_whose_hinges_are_creases(tmp_path: Path, stop: float) -> None:
    document = written(sheet_of(2, stop=stop))
    mesh, rows = document.mesh, 6
    # Two flaps to each of six rows on both sides, each with a hinge, each pair with a crease.
    assert len(mesh.faces) == 7 * 6 + 4 * rows
    assert mesh.crease.sum() == 6 * 6 + 7 * 5 + 4 * rows + 2 * rows
    assert mesh.pieces.max() == 0
    assert document.names[-1] == f"{2 * rows - 1},{6}"
    write_fold(tmp_path / "shell.fold", document)
    file = read_fold(tmp_path / "shell.fold")
    inspection = inspect_fold(file)
    assert inspection.passed
    # All border vertices of rows are inner ones now.
    assert len(inspection.sheet.inner) == 6 * 5 + 2 * rows
    for name in ("faces", "loops", "edges", "edge_faces", "crease"):
        np.testing.assert_array_equal(getattr(file.mesh, name), getattr(mesh, name))
    again = document_of_fold(file)
    assert again.assignment == document.assignment
    for one, other in zip(again.states, document.states, strict=True):
        np.testing.assert_array_equal(one.positions, other.positions)
        np.testing.assert_array_equal(one.fold_angles_deg, other.fold_angles_deg)


def test_fold_angles_of_hinges_are_those_of_the_positions() -> None:
    sheet = sheet_of(4)
    drives = np.linspace(0, np.pi * (1 - 1e-6), 9)
    residuals, assignment = measure_with_flaps(sheet, drives)
    assert max(residuals.panel_length, residuals.planarity) < 1e-13
    # Near the lock angles of flaps are known to fewer digits.
    assert max(residuals.sector_sum_rad, residuals.fold_angle_rad) < 1e-9
    assert assignment.constant
    assert assignment.maekawa


def test_the_flat_pattern_is_one_outline_with_slits() -> None:
    document = written(sheet_of(2))
    part = whole_sheet(document)
    (outline,) = part.outlines
    assert signed_areas(outline) == pytest.approx(document.areas().sum())
    for joint in ("tabs", "strips"):
        workshop = Workshop(stock=(6.0, 6.0), joint=joint)
        layout = lay_out(document, workshop)
        cut = sum(len(part.panels) for part in layout.parts)
        assert cut == len(document.mesh.faces)


def test_flaps_are_clipped_on_in_pairs() -> None:
    design = replace(
        design_flat_foldable(FlatFoldablePattern(rows=5, columns=5)), mechanism=sheet_of(2)
    )
    clipped = design.with_clipped_flaps()
    assert clipped.mechanism is design.mechanism.without_flaps()
    document = document_of_design(clipped)
    whole, rows = written(sheet_of(2)), 6
    assert len(document.attached) == 2 * rows
    names = [each.panel_name(k) for each in document.attached for k in (0, 1)]
    assert sorted(names) == sorted(whole.names[-4 * rows :])
    # They stand where they are folded with the sheet, whose state is the same.
    everything = laid_flat(document)
    assert everything.areas().sum() == pytest.approx(whole.areas().sum())
    for each in document.attached:
        for panel in (0, 1):
            number = whole.names.index(each.panel_name(panel))
            corners = np.sort(each.shell.positions[each.mesh.faces[panel]], axis=0)
            expected = np.sort(whole.shell.positions[whole.mesh.faces[number]], axis=0)
            np.testing.assert_allclose(corners, expected, atol=1e-13)
    lock = find_lock(clipped)
    assert lock.clipped_contact is None
    assert not lock.early


def test_what_slit_flaps_weigh_and_keep_apart_in_a_structure() -> None:
    sheet = sheet_of(2)
    bare = sheet.without_flaps()
    hung = hung_area(sheet, bare.grid, bare.grid.vertex_count)
    flaps = area_of(sheet) - area_of(bare)
    assert hung.sum() == pytest.approx(flaps, rel=1e-12)
    # Its centre of mass is that of the hinges.
    layout, flat = sheet.layout, sheet.points(0.0)
    middles = np.array([flat[layout.between(*pair)].mean(axis=0) for pair in layout.hinges])
    areas = written(sheet).areas()[layout.hinges[:, 0]]
    own = flat[: bare.grid.vertex_count]
    np.testing.assert_allclose(hung @ own, areas @ middles, atol=1e-12)
    # The distance of vertices that flaps keep apart falls until they are shut, and stands there.
    (upper, lower) = np.array(kept_apart(sheet, bare.grid, 0)).swapaxes(0, 1)
    drives = np.pi * np.array([0.2, 0.5, 0.9, 1.0])
    places = sheet.positions(drives)
    apart = [np.linalg.norm(places[:, r, c] - places[:, s, d], axis=-1)
             for (r, c), (s, d) in zip(upper, lower, strict=True)]  # fmt: skip
    assert len(apart) == 12
    assert (np.diff(apart, axis=1) < 0).all()


@thorough
@pytest.mark.parametrize("flap", [0.05, "auto"])
def test_a_design_file_asks_for_them(flap: float | str) -> None:
    tables = {
        "shell": {"family": "flat-foldable", "unit": "m"},
        "target": {"surface": {"formula": "sqrt(25 - x**2 - y**2)", "x": [-3, 3], "y": [-3, 3]}},
        "pattern": {"rows": 5, "columns": 5, "flap": flap},
        "motion": {"frames": 5},
    }
    shell = make_shell(check_design(tables, Path("cap.toml")), skip=["deviation"])
    lock, width = shell.report.lock, shell.design.flap
    assert (lock.cause, lock.early) == ("flaps", False)
    assert lock.path is not None
    assert width == flap if flap != "auto" else 0.1 < width < 2
    assert shell.report.deployment.flap_attachment == "folded"
    assert shell.report.quantities.panels == 36 + 4 * 5


@pytest.mark.parametrize("apart", [1e-4, 1e-3])
def test_how_far_flaps_are_open_short_of_the_lock(apart: float) -> None:
    # Guide: 2 sqrt(d/x), short of the lock by a fold angle d of the row's crease. The next term is
    # smaller by about d/x.
    sheet = sheet_of(2)
    x = np.abs(sheet.bare.sheet.net.x).ravel()
    for row, tangent in enumerate(x):
        folded = np.tan(np.arctan(tangent) - apart / 2) / tangent
        drive = 2 * np.arcsin(folded)
        open_by = np.pi - np.abs(sheet.flap_folds(drive)[row])
        assert open_by == pytest.approx(2 * np.sqrt(apart / tangent), rel=5 * apart / tangent)


BENCHMARK = {
    "cap": {"formula": "sqrt(1 - x**2 - y**2)", "x": [-0.5, 0.5], "y": [-0.5, 0.5]},
    "small cap": {"formula": "sqrt(1 - x**2 - y**2)", "x": [-0.35, 0.35], "y": [-0.35, 0.35]},
    "ellipsoid": {
        "formula": "0.8*sqrt(1 - x**2/2.25 - y**2)",
        "x": [-0.825, 0.825],
        "y": [-0.55, 0.55],
    },
    "saddle": {"formula": "0.25*(x**2 - y**2)", "x": [-1, 1], "y": [-1, 1]},
    "hypar": {"formula": "0.5*x*y", "x": [-1, 1], "y": [-1, 1]},
    "half cylinder": {"formula": ["u", "-cos(v)", "sin(v)"], "u": [0, 3], "v": [0, np.pi]},
    "torus": {
        "formula": ["(2 + cos(v))*sin(u)", "sin(v)", "(2 + cos(v))*cos(u)"],
        "u": [-0.69813, 0.69813],
        "v": [-0.69813, 0.69813],
    },
}


@pytest.mark.slow
@thorough
@pytest.mark.parametrize("name", BENCHMARK)
def test_surfaces_of_the_benchmark_lock(name: str) -> None:
    tables = {
        "shell": {"family": "flat-foldable", "unit": "m"},
        "target": {"surface": BENCHMARK[name]},
        "pattern": {"rows": 15, "columns": 15, "flap": "auto"},
        "motion": {"frames": 5},
    }
    shell = make_shell(check_design(tables, Path("shell.toml")), skip=["deviation", "pack"])
    lock, sheet = shell.report.lock, shell.design.mechanism
    assert isinstance(sheet, SlitFlaps)
    assert (lock.cause, lock.early, lock.touching_at_end) == ("flaps", False, ())
    assert lock.path is not None
    drives = np.append(np.linspace(0, np.pi, 30), np.pi * (1 - 1e-9))
    assert changes_of_lengths(sheet, drives) < 1e-12
    np.testing.assert_allclose(angles_between_flaps(sheet, np.pi), 180.0, rtol=0, atol=1e-6)
    assert len(sheet.layout.pairs) == 30
