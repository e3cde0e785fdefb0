"""Boards in the formats of meshes: closed around each board, with its volume and its name."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import meshio
import numpy as np
import pytest

from cad_tools import closed_volume
from documents import thick_document
from orishell.document import Document, Part
from orishell.io.format import Settings
from orishell.io.formats.gltf import write_gltf
from orishell.io.formats.obj import write_obj
from orishell.io.formats.ply import write_ply
from orishell.io.formats.rhino import write_rhino
from orishell.io.formats.stl import HEADER_LENGTH, write_stl

CONSTRUCTIONS = ("sandwich", "bevel")
FACET = np.dtype([("normal", "<f4", (3,)), ("corners", "<f4", (3, 3)), ("attributes", "<u2")])


@pytest.fixture(scope="module", params=CONSTRUCTIONS)
def document(request: pytest.FixtureRequest) -> Document:
    return thick_document("orthodiagonal", request.param)


def pieces(document: Document, state: str = "target") -> tuple[Part, ...]:
    return tuple(part for part, _ in document.parts_in(state))


def expected_volumes(document: Document, state: str = "target") -> np.ndarray:
    return np.concatenate([p.boards.volumes() for p in pieces(document, state) if p.boards])


def expected_names(document: Document) -> list[str]:
    return [p.board_name(board) for p in pieces(document) for board in range(len(p.boards or ()))]


def volume_of_corners(corners: np.ndarray) -> float:
    """The volume between triangles (T, 3, 3) whose common corners have the same coordinates."""
    vertices, triangles = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    return closed_volume(vertices, triangles.reshape(-1, 3))


def in_boards(corners: np.ndarray, document: Document, state: str) -> list[np.ndarray]:
    """Triangles (T, 3, 3) cut into those of each board, of which each has the same number here."""
    count = sum(len(each.boards or ()) for each in pieces(document, state))
    return list(corners.reshape(count, -1, 3, 3))


@pytest.mark.parametrize("state", ["flat", "target"])
def test_stl(document: Document, state: str, tmp_path: Path) -> None:
    write_stl(tmp_path / "a.stl", document, Settings(state=state))
    facets = np.frombuffer((tmp_path / "a.stl").read_bytes(), FACET, offset=HEADER_LENGTH + 4)
    boards = in_boards(facets["corners"], document, state)
    found = [volume_of_corners(each) for each in boards]
    np.testing.assert_allclose(found, expected_volumes(document, state), rtol=1e-4)


@pytest.mark.parametrize("state", ["flat", "target"])
def test_ply_to_the_last_digits(document: Document, state: str, tmp_path: Path) -> None:
    write_ply(tmp_path / "a.ply", document, Settings(state=state))
    mesh = meshio.read(tmp_path / "a.ply")
    boards = in_boards(mesh.points[mesh.cells_dict["triangle"]], document, state)
    found = [volume_of_corners(each) for each in boards]
    np.testing.assert_allclose(found, expected_volumes(document, state), rtol=1e-11)


def test_obj_has_a_group_for_each_board(document: Document, tmp_path: Path) -> None:
    moved = replace(document, origin=np.array([0.0, 0.0, 4.0]))
    write_obj(tmp_path / "a.obj", moved, Settings())
    lines = (tmp_path / "a.obj").read_text().splitlines()
    points = np.array([line.split()[1:] for line in lines if line.startswith("v ")], float)
    assert points[:, 1].min() > 1.0  # y up, in the world
    groups: dict[str, list[list[int]]] = {}
    for line in lines:
        if line.startswith("g "):
            name = line[2:]
            groups[name] = []
        if line.startswith("f "):
            groups[name].append([int(corner) - 1 for corner in line.split()[1:]])
    assert [name.replace("_", " ") for name in groups] == expected_names(document)
    found = [volume_of_corners(points[np.array(faces)]) for faces in groups.values()]
    np.testing.assert_allclose(found, expected_volumes(document), rtol=1e-11)


def test_3dm_has_closed_meshes_on_the_layers_of_their_sides(
    document: Document, tmp_path: Path
) -> None:
    import rhino3dm

    write_rhino(tmp_path / "a.3dm", document, Settings())
    model: Any = rhino3dm.File3dm.Read(str(tmp_path / "a.3dm"))
    layers = {layer.Index: layer.FullPath for layer in model.Layers}
    solids = [
        each
        for each in model.Objects
        if isinstance(each.Geometry, rhino3dm.Mesh)
        and layers[each.Attributes.LayerIndex].split("::")[1] != "mesh"
    ]
    names = [each.Attributes.Name.removeprefix("panel ") for each in solids]
    assert names == expected_names(document)
    for name, each in zip(names, solids, strict=True):
        assert each.Geometry.IsClosed
        side = layers[each.Attributes.LayerIndex].split("::")[1]
        assert side == (name.split()[1] if " " in name else "panels")
    assert {layers[each.Attributes.LayerIndex].split("::")[0] for each in solids} == {
        "shell",
        "board 1",
        "board 2",
    }


def test_glb_nodes_carry_their_boards(document: Document, tmp_path: Path) -> None:
    """In metres, in the panel's own frame, closed, with normals that point outwards."""
    from pygltflib import GLTF2

    write_gltf(tmp_path / "a.glb", document, Settings())
    file = GLTF2().load(str(tmp_path / "a.glb"))
    blob = file.binary_blob()

    def numbers(accessor: int) -> np.ndarray:
        entry = file.accessors[accessor]
        view = file.bufferViews[entry.bufferView]
        begin = (view.byteOffset or 0) + (entry.byteOffset or 0)
        return np.frombuffer(blob, "<f4", 3 * entry.count, begin).reshape(-1, 3)

    assert document.boards is not None
    found: dict[int, list[float]] = {}
    for panel, node in enumerate(file.nodes[1:]):
        for primitive in file.meshes[node.mesh].primitives:
            if primitive.indices is None:
                corners = numbers(primitive.attributes.POSITION).reshape(-1, 3, 3)
                found.setdefault(panel, []).append(volume_of_corners(corners))
                normals = numbers(primitive.attributes.NORMAL).reshape(-1, 3, 3)
                away = corners - corners.mean(axis=(0, 1))
                assert ((away * normals).sum(axis=-1) > 0).all()
    assert [p for p, each in found.items() for _ in each] == document.boards.panels.tolist()
    volumes = np.concatenate([*found.values()])
    np.testing.assert_allclose(volumes, document.boards.volumes(), rtol=1e-4)


def test_a_panel_that_is_one_solid_has_no_surface_inside_it(tmp_path: Path) -> None:
    from pygltflib import GLTF2

    counts = {}
    for construction in CONSTRUCTIONS:
        write_gltf(tmp_path / "a.glb", thick_document("orthodiagonal", construction), Settings())
        file = GLTF2().load(str(tmp_path / "a.glb"))
        areas = [p for mesh in file.meshes for p in mesh.primitives if p.mode != 1]
        counts[construction] = len(areas) / len(file.meshes)
    assert counts == {"sandwich": 3.0, "bevel": 1.0}  # with the membrane; alone
