"""Binary PLY, read back by meshio."""

from dataclasses import replace
from pathlib import Path

import meshio
import numpy as np
import pytest

from documents import FAMILIES, demo_document, flat_only, folded_only
from orishell.document import Document
from orishell.io.format import Settings
from orishell.io.formats.ply import write_ply

DEMO = demo_document()


def write(path: Path, document: Document) -> Path:
    write_ply(path / "shell.ply", document, Settings())
    return path / "shell.ply"


@pytest.mark.parametrize("family", FAMILIES)
def test_geometry_to_the_bit(family: str, tmp_path: Path) -> None:
    document = demo_document(family)
    mesh = meshio.read(write(tmp_path, document))
    np.testing.assert_array_equal(mesh.points, document.shell.positions)
    assert [block.type for block in mesh.cells] == ["quad"]
    np.testing.assert_array_equal(mesh.cells[0].data, document.mesh.faces)


def test_unit_unknown_and_title_of_several_lines(tmp_path: Path) -> None:
    file = write(tmp_path, replace(DEMO, title="ü\nelement face 3", unit="unit"))
    assert b"\ncomment ? element face 3\ncomment Unit: unit. Up: z.\n" in file.read_bytes()
    assert len(meshio.read(file).cells[0].data) == len(DEMO.mesh.faces)


def test_flat_sheet_alone_and_states_alone(tmp_path: Path) -> None:
    flat = flat_only(DEMO)
    points = meshio.read(write(tmp_path, flat)).points
    np.testing.assert_array_equal(points[:, :2], flat.require_flat())
    assert not points[:, 2].any()
    folded = folded_only(DEMO)
    np.testing.assert_array_equal(
        meshio.read(write(tmp_path, folded)).points, folded.shell.positions
    )
