"""Binary STL, read back by meshio and by the layout that the format prescribes."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import meshio
import numpy as np
import pytest
from numpy.typing import NDArray

from documents import FAMILIES, demo_document, flat_only, folded_only
from orishell.document import Document
from orishell.io.format import Settings
from orishell.io.formats.stl import HEADER_LENGTH, write_stl
from orishell.motion.mesh import build_mesh

DEMO = demo_document()
FACET = np.dtype([("normal", "<f4", (3,)), ("corners", "<f4", (3, 3)), ("attributes", "<u2")])


def write(path: Path, document: Document, state: int | str = "target") -> Path:
    write_stl(path / "shell.stl", document, Settings(state=state))
    return path / "shell.stl"


def facets(file: Path) -> NDArray[Any]:
    data = file.read_bytes()
    assert int.from_bytes(data[HEADER_LENGTH : HEADER_LENGTH + 4], "little") == (
        (len(data) - HEADER_LENGTH - 4) / FACET.itemsize
    )
    return np.frombuffer(data, FACET, offset=HEADER_LENGTH + 4)


@pytest.mark.parametrize("family", FAMILIES)
def test_two_triangles_for_each_panel(family: str, tmp_path: Path) -> None:
    document = demo_document(family)
    mesh = meshio.read(write(tmp_path, document))
    corners = document.shell.positions[document.mesh.faces]
    expected = corners[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3, 3)
    assert [block.type for block in mesh.cells] == ["triangle"]
    np.testing.assert_array_equal(
        mesh.points[mesh.cells[0].data].astype(np.float32), expected.astype(np.float32)
    )


def test_normals_stand_on_the_front(tmp_path: Path) -> None:
    flat = facets(write(tmp_path, flat_only(DEMO)))
    np.testing.assert_array_equal(flat["normal"], np.tile([0, 0, 1], (len(flat), 1)))
    locked = facets(write(tmp_path, folded_only(DEMO)))
    a, b, c = np.moveaxis(locked["corners"].astype(np.float64), 1, 0)
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    np.testing.assert_allclose(locked["normal"], normals, atol=1e-4)


def test_header_names_unit_and_axis_and_is_not_that_of_a_text_file(tmp_path: Path) -> None:
    title = "solid ground, ü, " + 100 * "long "
    header = write(tmp_path, replace(DEMO, title=title, unit="in")).read_bytes()[:HEADER_LENGTH]
    assert header.startswith(b"orishell, unit in, z up: solid ground, ?, long")


def test_a_panel_with_a_corner_inwards_is_split_at_it(tmp_path: Path) -> None:
    """From corner 0 to corner 2 the dart's diagonal would run outside. Its area is by hand."""
    dart = Document(
        title="dart",
        unit="mm",
        mesh=build_mesh(np.array([[0, 1, 2, 3]]), 4),
        assignment=("B",) * 4,
        flat=np.array([[0.0, 0], [4, 0], [4, 4], [3, 1]]),
        fold_angles_deg=np.zeros(4),
        states=(),
        grid_shape=None,
        curves={},
    )
    a, b, c = np.moveaxis(facets(write(tmp_path, dart))["corners"].astype(np.float64), 1, 0)
    areas = np.cross(b - a, c - a)[:, 2] / 2
    assert (areas > 0).all()
    assert areas.sum() == pytest.approx(4.0)
