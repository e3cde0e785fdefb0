"""Whole boards in files: carried rigidly, named, counted, and no part of what is of the sheet."""

from __future__ import annotations

import csv
import json
import struct
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from command_line import orishell
from orishell.conventions.errors import InputError
from orishell.design_file.file import check_design
from orishell.io.format import Settings
from orishell.io.formats.calculix import write_calculix
from orishell.io.formats.tables import write_tables
from orishell.io.formats.vtk import write_vtk
from orishell.io.solids import mesh_of, solids_in
from orishell.io.view import dump_view
from orishell.motion.hinges import Hinges
from orishell.motion.quads import grid_corners, longer_diagonals, unit_normals
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import MEASURES

TABLES = {
    "shell": {"family": "flat-foldable", "unit": "m"},
    "pattern": {"rows": 3, "columns": 4, "sheet": "miura"},
    "panel": {"construction": "hinged", "thickness": 0.02, "gap": 0.002, "density": 500},
    "motion": {"frames": 7},
    "deployment": {"from": "pack"},
}
PANELS = 20


@cache
def shell() -> Shell:
    return make_shell(check_design(TABLES, Path("shell.toml")), skip=("remedies", "stock"))


def test_boards_are_carried_rigidly_with_their_panels_in_every_state() -> None:
    """Seen from the shifted corners of its panel every board stands still."""
    document = shell().document
    assert document.boards is not None
    seen = []
    for state in document.states:
        corners = document.panel_corners(state)
        first = longer_diagonals(document.panel_corners(document.states[-1]))
        panel = np.arange(len(corners))
        x = corners[panel, first + 2] - corners[panel, first]
        x /= np.linalg.norm(x, axis=1, keepdims=True)
        z = unit_normals(corners)
        axes = np.stack([x, np.cross(z, x), z], axis=-1)[document.boards.panels]
        away = document.boards_in(state) - corners.mean(axis=1)[document.boards.panels, None, None]
        seen.append(np.einsum("bij,bhki->bhkj", axes, away))
    assert np.ptp(seen, axis=0).max() < 1e-14


def test_hinges_join_their_boards_in_every_state() -> None:
    """Ends of a hinge are in one place, seen from either of its boards."""
    document, hinges = shell().document, shell().design.hinges
    assert isinstance(hinges, Hinges)
    rows, columns = hinges.levels.shape
    for state in document.states:
        grid = state.positions.reshape(rows + 1, columns + 1, 3)
        panel = document.panel_corners(state).reshape(rows, columns, 4, 3)
        normal = unit_normals(grid_corners(grid))
        # Left ends of row hinges: corner 1 of the panel above, corner 0 of the one below.
        for (first, one), (second, other), height in (
            ((np.s_[:-1], 1), (np.s_[1:], 0), hinges.heights.row),
            ((np.s_[:, :-1], 3), (np.s_[:, 1:], 0), hinges.heights.column),
        ):
            near, far = (
                panel[part][..., corner, :] + height[..., None] * normal[part]
                for part, corner in ((first, one), (second, other))
            )
            assert np.abs(near - far).max() < 1e-14


def test_parts_have_names_of_their_own_and_are_closed() -> None:
    (solids,) = solids_in(shell().document, "target")
    boards = solids.boards
    assert len(set(solids.names)) == len(solids.names)
    assert int((~boards.arms).sum()) == PANELS
    assert sum(" arm " in name for name in solids.names) == int(boards.arms.sum()) > 0
    mesh = mesh_of((solids,))
    edges = np.concatenate([mesh.triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    assert len(np.unique(edges, axis=0)) == len(edges)
    assert set(map(tuple, edges)) == set(map(tuple, edges[:, ::-1]))


def test_the_report_says_what_is_of_boards() -> None:
    report = shell().report
    panel, bill = report.panel, report.quantities.built
    assert panel is not None
    assert bill is not None
    assert panel.hinged is not None
    assert panel.boards == bill.boards.solid == PANELS
    assert panel.hinged.longest_arm == pytest.approx(3 * 0.02, abs=1e-12)
    assert panel.largest_setback == pytest.approx(0.001)
    assert 0.98 < panel.hinged.board_share < 1
    assert panel.hinged.board_share == pytest.approx(bill.board_area / report.sheet.area)
    assert bill.mass_kg.total == pytest.approx(500 * 0.02 * bill.board_area)
    assert not any("sheet without a thickness" in warning for warning in report.warnings)
    packed = report.deployment.packed
    assert packed is not None
    # All boards lie on each other at 180 degrees, and arms reach no farther than the stack.
    assert packed.height == pytest.approx(PANELS * 0.02, rel=1e-3)
    assert packed.layers > 1


def test_hinges_are_a_table(tmp_path: Path) -> None:
    write_tables(tmp_path / "panels.csv", shell().document, Settings())
    rows = list(csv.DictReader((tmp_path / "hinges.csv").read_text().splitlines()))
    hinges = shell().design.hinges
    assert isinstance(hinges, Hinges)
    assert len(rows) == hinges.heights.row.size + hinges.heights.column.size
    heights = np.concatenate([hinges.heights.row.ravel(), hinges.heights.column.ravel()])
    assert np.array_equal([float(row["height_m"]) for row in rows], heights)
    assert max(float(row["arm_1_m"]) for row in rows) == hinges.longest_arm
    creases = list(csv.DictReader((tmp_path / "creases.csv").read_text().splitlines()))
    beside = [{row["panel_1"], row["panel_2"]} for row in rows]
    assert beside == [{row["panel_1"], row["panel_2"]} for row in creases]
    signs = {"M": "bottom", "V": "top"}
    assert [row["side"] for row in rows] == [signs[row["assignment"]] for row in creases]


def test_the_viewer_is_told_how_far_panels_are_shifted() -> None:
    document = shell().document
    data = dump_view(document)
    (size,) = struct.unpack_from("<I", data)
    header = json.loads(data[4 : 4 + size])
    place = header["arrays"]["panel_shifts"]
    count = int(np.prod(place["shape"]))
    found = np.frombuffer(data, "<f4", count, 4 + size + place["offset"]).reshape(place["shape"])
    assert found.shape == (len(document.states), PANELS, 3)
    hinges = document.boards.hinges if document.boards is not None else None
    assert isinstance(hinges, Hinges)
    for state, shifts in zip(document.states, found, strict=True):
        normals = unit_normals(state.positions[document.mesh.faces])
        np.testing.assert_allclose(shifts, hinges.shifts(normals), atol=1e-6)
    # In the flat sheet nothing is shifted.
    assert not found[document.named["flat"]].any()


def test_structures_of_hinged_boards_are_written_but_for_calculix(tmp_path: Path) -> None:
    supports = [{"at": [[0, 0], [0, 5], [4, 0], [4, 5]], "kind": "pinned"}]
    tables = TABLES | {
        "structure": {"material": "birch plywood", "supports": supports, "cells": 3},
        "load_case": [{"name": "weight", "self_weight": True}],
    }
    file = check_design(tables, Path("shell.toml"))
    analysed = make_shell(file, clash="unexamined", skip=("remedies", "verification", *MEASURES))
    settings = Settings()
    write_vtk(tmp_path / "shell.vtu", analysed.document, settings)
    with pytest.raises(InputError, match="not written for CalculiX") as caught:
        write_calculix(tmp_path / "shell.inp", analysed.document, settings)
    assert caught.value.keys == ("panel.construction",)


def test_every_format_is_written(tmp_path: Path) -> None:
    text = """
[shell]
family = "flat-foldable"
unit = "m"
[pattern]
rows = 2
columns = 2
sheet = "miura"
[panel]
construction = "hinged"
thickness = 0.02
hinge = { knuckle = 0.003 }
[motion]
frames = 3
"""
    (tmp_path / "shell.toml").write_text(text)
    asked = "3dm,3mf,csv,dxf,fold,glb,html,obj,pdf,ply,stl,svg,vtu"
    ran = orishell("design", "shell.toml", "--out", "out", "--write", asked, cwd=tmp_path)
    assert ran.returncode == 0, ran.stderr
    assert (tmp_path / "out" / "hinges.csv").exists()
