"""Boards on slit flaps: apart on the way to the lock, on the sheet or clipped on, and counted."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from cad_tools import objects_of, read_3mf, require_build123d
from mechanisms import TURNED, flat_foldable, random_net
from orishell.clash.acceleration_bounds import EdgeBounds, NormalBounds
from orishell.clash.bodies import Bodies
from orishell.clash.body_path import find_first_body_contact
from orishell.clash.broad_phase import PanelTree
from orishell.design import Design, PanelSpec
from orishell.design_file import check_design
from orishell.families.flat_foldable.locks.slit import SlitFlaps
from orishell.families.flat_foldable.pattern import FlatFoldablePattern, design_flat_foldable
from orishell.io.format import Settings
from orishell.io.formats.step import write_step
from orishell.io.formats.threemf import write_3mf
from orishell.locking import find_lock
from orishell.locking.report import describe_panels
from orishell.locking.sheet import Sheet
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.quads import unit_normals
from orishell.numerics.arrays import Array
from orishell.shell.candidate import ended
from orishell.shell.designed import designed as design_asked
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import Work
from orishell.solids import build_panels, find_stop
from orishell.workshop import Workshop
from orishell.workshop.board_sheets import draw_boards
from overlaps import NOTHING, overlap
from samples import THOROUGH, led_by, thorough

STATES = 40 if THOROUGH else 16
BEYOND = 1e-2
"""Where boards meet, they overlap so far beyond (radians)."""
RANGES = 512
WIDER = 1.02
"""Flaps by so much wider than the widest, which are found to 1 %, meet something."""
BUILDS = {
    "sandwich": PanelSpec(thickness=0.01, membrane=0.0005),
    "bevel": PanelSpec(thickness=0.01, construction="bevel", gap=0.001),
}


def designed(
    seed: int, build: PanelSpec, stop: float | None = None, size: tuple[int, int] = (6, 5)
) -> Design:
    """A random sheet with flaps 0.2 and 0.3 wide; edges are about 1 long."""
    sheet = SlitFlaps(flat_foldable(random_net(*size, seed), **TURNED), (0.2, 0.3))
    design = replace(design_flat_foldable(FlatFoldablePattern(rows=5, columns=5)), mechanism=sheet)
    return replace(design.with_stop(find_stop(sheet, build) if stop is None else stop), panel=build)


SHEETS = [(2, "sandwich", None), (1, "bevel", None), (1, "sandwich", 0.0), (3, "sandwich", None)]


@pytest.mark.parametrize(("seed", "build", "stop"), led_by(SHEETS))
def test_boards_are_apart_to_the_lock(seed: int, build: str, stop: float | None) -> None:
    """Seen of manifold3d: no overlaps but of 1e-17, and of 1e-8 and more just beyond the lock."""
    design = designed(seed, BUILDS[build], stop, (6, 5) if THOROUGH else (3, 3))
    lock = find_lock(design)
    assert lock.built is not None
    assert (lock.cause, lock.early, lock.drive) == ("flaps", False, lock.target_drive)
    mechanism, boards = design.mechanism, lock.built.boards
    assert isinstance(mechanism, SlitFlaps)
    for drive in np.linspace(0.0, lock.closes_to, STATES):
        assert overlap(mechanism, boards, drive) < NOTHING
    if stop is None:
        assert overlap(mechanism, boards, lock.closes_to + BEYOND) > NOTHING
        report = describe_panels(design, lock)
        assert report is not None
        assert report.meeting is not None
        assert report.meeting.creases == len(mechanism.layout.pairs)


@thorough
def test_corners_are_cut_where_boards_meet_at_border_vertices() -> None:
    design = designed(1, BUILDS["bevel"])
    assert isinstance(design.mechanism, SlitFlaps)
    lock = find_lock(design)
    assert lock.built is not None
    cut = lock.built.reliefs > 0
    assert cut.any()
    assert not cut[:, 1:-1].any()
    whole = build_panels(design, lock.closes_to).boards
    drives = np.linspace(0.0, lock.closes_to, STATES)
    assert max(overlap(design.mechanism, whole, drive) for drive in drives) > NOTHING
    # Without cuts the proof names a flap and a panel, or two flaps, before the lock.
    sheet = Sheet.of(design)
    bodies = Bodies(whole, sheet.layout.faces, panels_laid_flat(design.mechanism))
    settled = lock.built.settled()
    met = find_first_body_contact(sheet.mechanism, sheet.end, 1e-9, bodies, settled=settled).contact
    assert met is not None
    found = sheet.contact_of_boards(met, whole)
    assert found.drive < lock.target_drive
    assert {column for _, column in found.panels} & {-1, design.mechanism.grid.columns - 1}


@pytest.mark.parametrize("build", led_by(BUILDS))
def test_clipped_boards_are_clear_at_the_target(build: str) -> None:
    design = designed(2, BUILDS[build]).with_clipped_flaps()
    lock = find_lock(design)
    assert (lock.early, lock.clipped_contact) == (False, None)
    assert lock.built is not None
    assert lock.built.flaps is not None
    assert design.clipped is not None
    everything = lock.built.with_flaps(design.clipped)
    assert len(everything) == len(lock.built.boards) + len(lock.built.flaps)
    assert overlap(design.clipped, everything, design.clipped.target_drive) < NOTHING
    # The sheet goes on beyond its target as without flaps.
    for drive in np.linspace(0.0, lock.closes_to, 10):
        assert overlap(design.mechanism, lock.built.boards, drive) < NOTHING


def test_flaps_that_fold_flat_carry_boards_on_one_face() -> None:
    design = designed(2, BUILDS["sandwich"], 0.0)
    mechanism = design.mechanism
    assert isinstance(mechanism, SlitFlaps)
    built = build_panels(design, mechanism.target_drive)
    layout, count = mechanism.layout, mechanism.grid.panel_count
    of_flaps = built.boards.chosen(built.boards.panels >= count)
    np.testing.assert_array_equal(of_flaps.panels, np.flatnonzero(layout.flaps))
    closing = np.sign(mechanism.flap_folds(mechanism.target_drive))
    for panels in layout.pairs.T:
        np.testing.assert_array_equal(of_flaps.sides[panels - count], -closing)


@pytest.mark.parametrize("number", [0, 100, 300, 500])
def test_normals_of_flaps_swing_no_faster_than_their_bounds(number: int) -> None:
    """Also the vectors along both of their creases, by bounds of rows and columns beside them."""
    sheet = designed(3, BUILDS["sandwich"]).mechanism.least_turning
    assert isinstance(sheet, SlitFlaps)
    layout, end = sheet.layout, sheet.end_drive
    tree = PanelTree.over(layout.faces, layout.first.astype(np.float64))
    bounds = EdgeBounds(sheet, (0.0, end), tree).within(number / RANGES, (number + 1) / RANGES)
    normals = NormalBounds(layout, sheet.points(0.0)).within(*bounds.steps)
    h, middle = 0.5 * end / RANGES, (number + 0.5) * end / RANGES
    corners = sheet.points(np.array([middle - h, middle, middle + h]))[:, layout.faces]

    def swing(vectors: Array) -> Array:
        return np.asarray(np.linalg.norm(np.diff(vectors, n=2, axis=0)[0], axis=-1) / h**2)

    assert (swing(unit_normals(corners)) <= normals * (1 + 1e-9) + 1e-8).all()
    flaps = layout.flaps
    own = layout.faces[flaps] < layout.grid.vertex_count
    at = own.argmax(axis=1)
    assert (own.sum(axis=1) == 1).all()
    quads, rows = corners[:, flaps], np.arange(len(at))
    for ends, steps, axis in (([3, 2], bounds.steps[0], 1), ([1, 0], bounds.steps[1], 0)):
        there = np.array(ends)[at]
        found = swing(quads[:, rows, there] - quads[:, rows, at])
        assert (found <= steps[layout.first[flaps, axis]] * (1 + 1e-9) + 1e-8).all()


DOME = {
    "shell": {"family": "flat-foldable", "unit": "m"},
    "target": {"surface": {"formula": "sqrt(25 - x**2 - y**2)", "x": [-3, 3], "y": [-3, 3]}},
    "pattern": {"rows": 5, "columns": 5, "flap": 0.2},
    "panel": {
        "thickness": 0.009,
        "membrane": 0.0005,
        "density": 700,
        "membrane_density": 900,
    },
    "motion": {"frames": 5},
}


def dome(attachment: str) -> Shell:
    tables = {**DOME, "deployment": {"flap_attachment": attachment}}
    return make_shell(check_design(tables, Path("dome.toml")), skip=["deviation", "pack"])


@pytest.mark.slow
@thorough
def test_the_widest_flaps_are_those_whose_boards_meet_nothing() -> None:
    file = check_design(DOME, Path("dome.toml")).changed({"pattern.flap": "auto"})
    design, lock = ended(file, design_asked(file), Work())
    assert (lock.cause, lock.early) == ("flaps", False)
    wider = file.changed({"pattern.flap": WIDER * design.flap})
    contact = find_lock(design_asked(wider)).first_contact
    assert contact is not None
    assert contact.drive < lock.target_drive


@thorough
@pytest.mark.parametrize("attachment", ["clipped", "folded"])
def test_every_board_of_a_dome_is_cut_weighed_and_drawn(attachment: str, tmp_path: Path) -> None:
    require_build123d()
    shell = dome(attachment)
    lock, document = shell.report.lock, shell.document
    assert lock.cause == ("flaps" if attachment == "folded" else "boards")
    assert not lock.early
    panels = 36 + 4 * 5  # those of the sheet, and four flaps to each row
    bill, report = shell.report.quantities.built, shell.report.panel
    assert bill is not None
    assert report is not None
    assert bill.mass_kg is not None
    assert (bill.boards.top, bill.boards.bottom, report.boards) == (panels, panels, 2 * panels)
    assert report.meeting is not None
    assert report.meeting.creases == 2 * 5
    assert shell.lock.built is not None
    pieces = [each for each in (shell.lock.built.boards, shell.lock.built.flaps) if each]
    volume = sum(float(each.volumes().sum()) for each in pieces)
    assert bill.mass_kg.boards == pytest.approx(700 * volume, rel=1e-6)
    write_step(tmp_path / "dome.step", document, Settings())
    solids = [file.read_text().count("MANIFOLD_SOLID_BREP(") for file in tmp_path.iterdir()]
    assert set(solids) == {2 * panels}
    write_3mf(tmp_path / "dome.3mf", document, Settings(workshop=Workshop(model_scale=0.1)))
    assert len(objects_of(read_3mf(tmp_path / "dome.3mf"))) == 2 * panels
    drawn = draw_boards(document, Workshop(stock=(4.0, 3.6)))
    cut = [line for _, sheet in drawn for line in sheet.lines if line.layer == "CUT"]
    assert len(cut) == 2 * panels
