"""Second skins of random shells: manifold3d finds nothing before the proved ends of the motion."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from design_tables import made, mended
from orishell.conventions.errors import DesignError, InputError
from orishell.design_file import check_design
from orishell.io.joint_tables import hung_table
from orishell.motion.quads import signed_areas
from orishell.shell.export import write_shell
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import MEASURES
from overlaps import NOTHING
from samples import THOROUGH
from skinned import random_tables, skinned
from stiffened import bodies, common, shell_of

QUICK, ALL = (0, 1, 2, 5, 8, 60, 62, 80, 81, 83), 110


def test_random_shells_have_a_second_skin_or_a_reason() -> None:
    """So the test below sees some of each."""
    found = [skinned(number)[1] for number in QUICK]
    assert sum(isinstance(each, Shell) for each in found) >= len(QUICK) // 2


@pytest.mark.parametrize("number", range(ALL) if THOROUGH else QUICK)
def test_nothing_meets_where_the_motion_is_proved(number: int) -> None:
    """Volume that skin and walls have in common with others, in states between both ends."""
    design, shell = skinned(number)
    if isinstance(shell, DesignError):
        assert shell.place
        with pytest.raises(DesignError) as caught:
            made(design)
        for remedy in caught.value.remedies:
            assert shell_of(mended(design, remedy)).design.carried
        return
    motion, document = shell.lock.skin, shell.document
    assert motion is not None
    shut = 1e-5 if document.boards is None else -1e-9
    start, stop = motion.joined_from, shell.lock.closes_to * (1 - shut)
    looked = 0
    for state, each in enumerate(document.states):
        assert each.drive_deg is not None
        if not np.rad2deg(start) <= each.drive_deg <= np.rad2deg(stop):
            continue
        names, found = bodies(document, state)
        total = sum(body.volume() for body in found)
        for kind in ("skin", "wall"):
            assert max(common(names, found, kind).values(), default=0.0) < NOTHING * total
        looked += 1
    assert looked


def shell_with(**asked: Any) -> Shell:
    design = random_tables(0, 0)
    design["pattern"] |= {"rows": 5, "columns": 4, "flap": 0, "xi_deg": 60, "plane_deg": 90}
    design["stiffeners"] = {"kind": "skin", **asked}
    return shell_of(design)


def test_gap_cells_and_walls_are_reported() -> None:
    shell = shell_with(gap=0.05)
    skin = shell.report.lock.skin
    assert skin is not None
    assert skin.gap == pytest.approx(0.05, rel=1e-9)
    assert skin.largest_gap >= skin.gap
    assert skin.cells == len(skin.walls) - 1 > 0
    air = shell.report.deployment.air
    if air is not None:
        assert air.at_target == pytest.approx(skin.volume, rel=1e-12)
    (row,) = (row for row in shell.report.verdict if row.subject == "skin")
    assert row.sign == "holds"
    assert row.finding.startswith("50 mm from the sheet at the least, on ")
    few = shell_with(gap=0.05, walls=[skin.walls[1]]).report.lock.skin
    assert few is not None
    assert (few.walls, few.cells, few.volume) == (skin.walls[1:2], 0, 0.0)


def test_it_weighs_as_the_sheet_does() -> None:
    plain = shell_of({k: v for k, v in shell_tables().items() if k != "stiffeners"})
    whole = shell_of(shell_tables())
    areas = [sum(part.areas().sum() for part in s.document.parts) for s in (plain, whole)]
    masses = [s.report.quantities.mass_kg for s in (plain, whole)]
    assert masses[0] is not None
    assert masses[1] is not None
    assert masses[1] / masses[0] == pytest.approx(areas[1] / areas[0], rel=1e-9)
    assert areas[1] > 2 * areas[0]


def shell_tables() -> dict[str, Any]:
    design = random_tables(0, 0)
    design["pattern"] |= {"rows": 5, "columns": 4, "flap": 0, "xi_deg": 60, "plane_deg": 90}
    design["stiffeners"] = {"kind": "skin", "gap": 0.05}
    design["workshop"] = {"areal_density": 2.0}
    design.pop("deployment", None)
    return design


def test_both_ends_of_a_wall_are_in_the_table_of_lines() -> None:
    """On the bottom of a panel of the sheet, and on the top of the one below it, as far along."""
    shell = shell_with(gap=0.05)
    table = hung_table(shell.document)
    assert table is not None
    rows = [[*map(str, row)] for row in table[1]]
    panels = len(shell.document.sheet.mesh.faces)
    assert len(rows) == 2 * sum(
        len(part.mesh.faces) for part in shell.document.attached if part.kind == "wall"
    )
    outer = {(r[0], r[1]): r for r in rows if not r[1].startswith("skin ")}
    inner = {(r[0], r[1].removeprefix("skin ")): r for r in rows if r[1].startswith("skin ")}
    assert outer.keys() == inner.keys()
    assert len(outer) <= panels
    assert {r[2] for r in outer.values()} == {"bottom"}
    assert {r[2] for r in inner.values()} == {"top"}


def test_what_has_no_room_is_refused_with_what_has() -> None:
    with pytest.raises(DesignError, match="face each other") as caught:
        made({**shell_tables(), "stiffeners": {"kind": "skin", "gap": 1.0}})
    (remedy,) = caught.value.remedies
    assert shell_of(mended(shell_tables(), remedy)).design.carried
    with pytest.raises(InputError, match="rows of panels"):
        shell_with(walls=[77])
    with pytest.raises(InputError, match="no row is named"):
        shell_with(walls=[])


def vault(**more: Any) -> dict[str, Any]:
    """A T-hedral vault with a second skin straight below it."""
    return {
        "shell": {"family": "t-hedral", "unit": "m"},
        "target": {
            "f": {"formula": "-0.5*x**2", "range": [-1.5, 1.5]},
            "g": {"formula": "0", "range": [0, 2]},
        },
        "pattern": {"rows": 7, "columns": 5, "flap": 0, "depth": 0.15},
        "stiffeners": {"kind": "skin", "gap": 0.1},
        "motion": {"frames": 6},
        "deployment": {"from": "pack"},
        **more,
    }


def test_a_skin_straight_below_is_there_from_one_end_to_the_other() -> None:
    shell = shell_of(vault())
    skin = shell.report.lock.skin
    assert skin is not None
    assert skin.gap == pytest.approx(0.1, rel=1e-9)
    assert (skin.joined_from, skin.opening, skin.closing) == (0.0, None, None)
    assert skin.walls == tuple(range(8))
    assert skin.cells == 7
    (row,) = (row for row in shell.report.verdict if row.subject == "skin")
    assert row.sign == "holds"
    assert "cells of" in row.finding
    assert ": nothing touches from 0 to " in row.finding


def test_it_is_cut_in_strips_and_its_walls_are_long_rectangles() -> None:
    """As large as they are in the shell; walls as high as both skins are apart straight down."""
    document = shell_of(vault()).document.as_cut()
    skin, *walls = document.attached
    for part in document.parts:
        flat, folded = part.require_flat()[part.mesh.faces], part.shell.positions[part.mesh.faces]
        for one, other in ((0, 1), (1, 2), (0, 2), (1, 3)):
            np.testing.assert_allclose(
                np.linalg.norm(flat[:, one] - flat[:, other], axis=-1),
                np.linalg.norm(folded[:, one] - folded[:, other], axis=-1),
                rtol=0,
                atol=1e-12,
            )
        assert (signed_areas(flat) > 0).all()
    assert skin.kind == "skin"
    assert len(skin.mesh.faces) == 8 * 4
    assert skin.mesh.crease.sum() == 7 * 4
    heights = [np.ptp(wall.require_flat()[:, 1]) for wall in walls]
    np.testing.assert_allclose(heights, heights[0], rtol=0, atol=1e-12)


def test_walls_hang_where_their_lines_are_drawn() -> None:
    """Of strips as they are cut: as far along both sides of a panel as in the shell."""
    document = shell_of(vault()).document.as_cut()
    skin, *walls = document.attached
    places = {wall.names[0].partition(",")[0]: wall for wall in walls}
    hung = [(document, line) for line in (wall.hung for wall in walls) if line is not None]
    assert skin.bears is not None
    for part, lines in (*hung, (skin, skin.bears)):
        for name, panel, ends in zip(lines.names, lines.panels, lines.ends, strict=True):
            corners, own = part.mesh.faces[panel], places[name]
            flat, folded = part.require_flat()[corners], part.shell.positions[corners]
            column = int(part.panel_name(int(panel)).rpartition(",")[2])
            row = 0 if part is document else 1
            wall = own.shell.positions.reshape(2, -1, 3)[row, column : column + 2]
            for end, (upper, lower), vertex in zip(ends, ((0, 1), (3, 2)), wall, strict=True):
                for corner in (upper, lower):
                    drawn = np.linalg.norm(end - flat[corner])
                    built = np.linalg.norm(vertex - folded[corner])
                    assert drawn == pytest.approx(built, abs=1e-12)


def test_files_have_it_in_every_state(tmp_path: Path) -> None:
    """Behind frames of the sheet, FOLD has one with all that hangs on it for each of its states."""
    shell = make_shell(check_design(vault(), Path("vault.toml")), skip=MEASURES)
    write_shell(shell, tmp_path, formats=["fold", "dxf", "glb", "booklet"])
    fold = json.loads((tmp_path / "shell.fold").read_text("utf-8"))
    states, parts = shell.document.states, shell.document.parts
    frames = [fold, *fold["file_frames"]]
    assert len(frames) == 2 * len(states)
    hung = frames[len(states) :]
    assert {frame["frame_parent"] for frame in hung[1:]} == {len(states)}
    for number, frame in enumerate(hung):
        points = np.concatenate([part.states[number].positions for part in parts])
        known = {*map(tuple, (points + shell.document.origin).tolist())}
        assert known.issuperset(map(tuple, frame["vertices_coords"]))
    # A panel with a wall across is two, joined; the wall is the third panel at that line.
    walls = [part for part in parts if part.kind == "wall"]
    lines = 2 * sum(len(part.mesh.faces) for part in walls)
    faces = hung[0]["faces_vertices"]
    assert len(faces) == sum(len(part.mesh.faces) for part in parts) + lines
    joined = zip(hung[0]["edges_vertices"], hung[0]["edges_assignment"], strict=True)
    at = [{*edge} for edge, letter in joined if letter == "J"]
    assert len(at) == lines
    assert all(sum(edge <= {*face} for face in faces) == 3 for edge in at)


def test_what_it_cannot_do_is_refused_with_what_works() -> None:
    inner = {"formula": "-0.4*x**2 - 0.3", "range": [-1.2, 1.2]}
    for message, tables in (
        ("no curve of its own", {"target": {**vault()["target"], "inner": inner}}),
        ("face each other", {"stiffeners": {"kind": "skin", "gap": 2.0}}),
    ):
        asked = vault(**tables)
        if "target" in tables:
            del asked["stiffeners"]["gap"]
        with pytest.raises(DesignError, match=message) as caught:
            made(asked)
        (remedy,) = caught.value.remedies
        assert shell_of(mended(asked, remedy)).design.carried
