"""Wavefront OBJ, read back by meshio."""

from dataclasses import replace
from pathlib import Path

import meshio
import numpy as np
import pytest

from documents import FAMILIES, demo_document, flat_only, folded_only
from orishell.conventions.errors import InputError
from orishell.document import Document
from orishell.io.format import Settings
from orishell.io.formats.obj import write_obj

DEMO = demo_document()


def read(path: Path, document: Document, state: int | str = "target") -> meshio.Mesh:
    write_obj(path / "shell.obj", document, Settings(state=state))
    return meshio.read(path / "shell.obj")


@pytest.mark.parametrize("family", FAMILIES)
def test_geometry_to_the_bit_with_y_up(family: str, tmp_path: Path) -> None:
    document = demo_document(family)
    mesh = read(tmp_path, document)
    assert {block.type for block in mesh.cells} == {"quad"}
    faces = np.concatenate([block.data for block in mesh.cells])
    np.testing.assert_array_equal(faces, document.mesh.faces)
    x, y, z = mesh.points.T
    np.testing.assert_array_equal(np.stack([x, -z, y], axis=1), document.shell.positions)


def test_one_group_for_each_row(tmp_path: Path) -> None:
    assert DEMO.grid_shape is not None
    rows, columns = DEMO.grid_shape
    mesh = read(tmp_path, DEMO)
    assert [len(block) for block in mesh.cells] == [columns - 1] * (rows - 1)


def test_one_group_where_there_is_no_grid(tmp_path: Path) -> None:
    mesh = read(tmp_path, replace(DEMO, grid_shape=None))
    assert [len(block) for block in mesh.cells] == [len(DEMO.mesh.faces)]


def test_title_unit_and_axis(tmp_path: Path) -> None:
    read(tmp_path, replace(DEMO, title="Größe\nv 0 0 0", unit="ft"))
    lines = (tmp_path / "shell.obj").read_text(encoding="utf-8").splitlines()
    assert lines[:2] == ["# Größe v 0 0 0", "# Unit: ft. Up: y."]


def test_flat_sheet_lies_on_the_ground(tmp_path: Path) -> None:
    flat = flat_only(DEMO)
    mesh = read(tmp_path, flat)
    assert not np.signbit(mesh.points[:, 1]).any()
    np.testing.assert_array_equal(mesh.points[:, [0, 2]] * [1, -1], flat.require_flat())


def test_chosen_state_without_flat_sheet(tmp_path: Path) -> None:
    folded = folded_only(DEMO)
    points = read(tmp_path, folded, state=1).points
    np.testing.assert_array_equal(points[:, 1], folded.states[1].positions[:, 2])
    with pytest.raises(InputError, match="no such state"):
        read(tmp_path, folded, state=99)
