"""Sheets with slit flaps, whose hinges are parts of panels' sides, in files for other programs."""

from __future__ import annotations

import csv
from pathlib import Path

import meshio
import numpy as np
import pygltflib
import pytest

from documents import slit_document
from orishell.conventions.colours import MEANINGS
from orishell.document import Document
from orishell.io.format import Settings
from orishell.io.formats.gltf import write_gltf
from orishell.io.formats.tables import write_tables
from orishell.io.formats.vtk import write_vtk
from orishell.io.solids import y_up


@pytest.fixture(scope="module")
def slit() -> Document:
    return slit_document()


def test_tables_call_panels_and_flaps_by_row_and_column(slit: Document, tmp_path: Path) -> None:
    write_tables(tmp_path / "panels.csv", slit, Settings())
    with (tmp_path / "panels.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [f"{each['row']},{each['column']}" for each in rows] == list(slit.names)
    write_vtk(tmp_path / "shell.vtu", slit, Settings())
    cells = meshio.read(tmp_path / "shell.vtu").cell_data
    called = [
        f"{row},{column}" for row, column in zip(*cells["row"], *cells["column"], strict=True)
    ]
    assert called == list(slit.names)


def test_every_edge_is_drawn_once_in_its_colour(slit: Document, tmp_path: Path) -> None:
    """Also those parts of a border between its hinges, to single precision."""
    write_gltf(tmp_path / "shell.glb", slit, Settings())
    file = pygltflib.GLTF2().load(str(tmp_path / "shell.glb"))
    blob = file.binary_blob()
    drawn: dict[str, list[np.ndarray]] = {}
    for node in file.nodes[1:]:
        x, y, z, w = node.rotation
        vector = np.array([x, y, z])
        for primitive in file.meshes[node.mesh].primitives:
            if primitive.mode != 1:
                continue
            points = _numbers(file, blob, primitive.attributes.POSITION).reshape(-1, 3)
            if primitive.indices is not None:
                points = points[_numbers(file, blob, primitive.indices)]
            # v + 2 q x (q x v + w v), for the rotation by a quaternion.
            moved = points + 2 * np.cross(vector, np.cross(vector, points) + w * points)
            ends = (moved + node.translation).reshape(-1, 2, 3)
            drawn.setdefault(file.materials[primitive.material].name, []).extend(ends)
    places = y_up(slit.shell.positions + slit.origin - slit.nearby)[slit.mesh.edges]
    size = np.ptp(places)
    meanings = np.array([MEANINGS[letter] for letter in slit.assignment])
    assert sorted(drawn) == sorted(set(meanings.tolist()))
    for meaning, lines in drawn.items():
        wanted = places[meanings == meaning]
        assert len(lines) == len(wanted)
        middles, expected = np.mean(lines, axis=1), wanted.mean(axis=1)
        away = np.linalg.norm(middles[:, None] - expected, axis=-1)
        assert away.min(axis=0).max() < 1e-6 * size
        spans = np.linalg.norm(np.diff(lines, axis=1)[:, 0], axis=-1)
        of_edges = np.linalg.norm(np.diff(wanted, axis=1)[:, 0], axis=-1)
        assert np.abs(spans - of_edges[away.argmin(axis=1)]).max() < 1e-5 * size


def _numbers(file: pygltflib.GLTF2, blob: bytes, number: int) -> np.ndarray:
    entry = file.accessors[number]
    view = file.bufferViews[entry.bufferView]
    kind, width = (np.float32, 3) if entry.type == "VEC3" else (np.uint16, 1)
    begin = view.byteOffset + entry.byteOffset
    return np.frombuffer(blob, kind, entry.count * width, begin).astype(
        np.float64 if width == 3 else np.int64
    )
