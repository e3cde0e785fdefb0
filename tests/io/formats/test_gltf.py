"""Binary glTF, read by pygltflib and played as the specification of glTF 2.0 says."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pygltflib
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from documents import FAMILIES, SMALL, demo_document, flat_only, folded_only
from orishell.conventions.errors import InputError
from orishell.conventions.quantities import MILLIMETRES
from orishell.document import Document, DocumentState
from orishell.io.format import Settings
from orishell.io.formats.gltf import SECONDS, write_gltf
from orishell.motion.mesh import build_mesh

Array = NDArray[np.float64]

DEMO = demo_document(size=SMALL)
WIDTHS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}
TYPES: dict[int, np.dtype[Any]] = {5126: np.dtype("<f4"), 5123: np.dtype("<u2")}


@dataclass(frozen=True)
class Scene:
    """What a viewer knows: shapes (F, 4, 3), poses, and keys (S, F, ...) if anything moves."""

    file: Any
    shapes: Array
    rest: tuple[Array, Array]
    times: Array
    places: Array
    turns: Array

    def corners(self, time: float) -> Array:
        """Corners (F, 4, 3) of all panels at a time: turned by slerp, moved along lines."""
        after = min(max(int(np.searchsorted(self.times, time)), 1), len(self.times) - 1)
        begin, end = self.times[after - 1], self.times[after]
        share = (time - begin) / (end - begin)
        place = (1 - share) * self.places[after - 1] + share * self.places[after]
        first, last = (Rotation.from_quat(self.turns[key]) for key in (after - 1, after))
        turn = first * Rotation.from_rotvec(share * (first.inv() * last).as_rotvec())
        return placed(self.shapes, place, turn.as_quat())


def read(path: Path, document: Document, state: int | str = "target") -> Scene:
    write_gltf(path / "shell.glb", document, Settings(state=state))
    file = pygltflib.GLTF2().load(str(path / "shell.glb"))
    blob = file.binary_blob()

    def accessor(number: int) -> Array:
        entry = file.accessors[number]
        view = file.bufferViews[entry.bufferView]
        width, kind = WIDTHS[entry.type], TYPES[entry.componentType]
        assert view.byteStride in (None, width * kind.itemsize)
        begin = view.byteOffset + entry.byteOffset
        assert entry.byteOffset + entry.count * width * kind.itemsize <= view.byteLength
        values = np.frombuffer(blob, kind, entry.count * width, begin).reshape(-1, width)
        if entry.min:
            np.testing.assert_array_equal(values.min(axis=0), np.float32(entry.min))
            np.testing.assert_array_equal(values.max(axis=0), np.float32(entry.max))
        return np.asarray(values, dtype=np.float64)

    root, *panels = file.nodes
    assert root.children == list(range(1, len(file.nodes)))
    primitives = [file.meshes[panel.mesh].primitives[0] for panel in panels]
    for primitive in primitives:
        assert file.accessors[primitive.attributes.POSITION].min
    shapes = np.stack([accessor(primitive.attributes.POSITION) for primitive in primitives])
    rest = (np.array([n.translation for n in panels]), np.array([n.rotation for n in panels]))
    keys: dict[tuple[int, str], Array] = {}
    times = np.zeros(0)
    for animation in file.animations:
        for channel in animation.channels:
            sampler = animation.samplers[channel.sampler]
            assert sampler.interpolation == "LINEAR"
            assert file.accessors[sampler.input].min
            times = accessor(sampler.input)[:, 0]
            keys[channel.target.node, channel.target.path] = accessor(sampler.output)
    nodes = range(1, len(file.nodes))
    both = (
        [np.stack([keys[node, path] for node in nodes], axis=1) for path in PATHS]
        if keys
        else [np.zeros(0)] * 2
    )
    return Scene(file, shapes, rest, times, *both)


PATHS = ("translation", "rotation")


def wanted(document: Document, state: DocumentState) -> Array:
    """Corners (F, 4, 3) in metres with y up."""
    x, y, z = state.positions.T * MILLIMETRES[document.unit] / 1000
    return np.stack([x, z, -y], axis=1)[document.mesh.faces]


def placed(shapes: Array, places: Array, turns: Array) -> Array:
    """Corners (F, 4, 3) of shapes that are turned and then moved."""
    turned = np.einsum("fij,fcj->fci", Rotation.from_quat(turns).as_matrix(), shapes)
    return np.asarray(turned + places[:, None])


def size(corners: Array) -> float:
    return float(np.linalg.norm(np.ptp(corners.reshape(-1, 3), axis=0)))


@pytest.mark.parametrize(
    ("family", "unit"),
    [*((family, "m") for family in FAMILIES), ("orthodiagonal", "mm"), ("orthodiagonal", "ft")],
)
def test_every_state_at_its_key(family: str, unit: str, tmp_path: Path) -> None:
    """Single precision, so within 1e-6 of the size."""
    document = replace(demo_document(family, size=SMALL), unit=unit)
    scene = read(tmp_path, document)
    assert len(scene.times) == len(document.states)
    for number, state in enumerate(document.states):
        expected = wanted(document, state)
        found = placed(scene.shapes, scene.places[number], scene.turns[number])
        assert np.abs(found - expected).max() < 1e-6 * size(expected)


@pytest.mark.parametrize("state", [0, 3, "target"])
def test_nodes_stand_in_the_chosen_state(state: int | str, tmp_path: Path) -> None:
    scene = read(tmp_path, DEMO, state)
    expected = wanted(DEMO, DEMO.state(state))
    assert np.abs(placed(scene.shapes, *scene.rest) - expected).max() < 1e-6 * size(expected)


def test_one_node_for_each_panel(tmp_path: Path) -> None:
    file = read(tmp_path, DEMO).file
    names = [node.name for node in file.nodes[1:]]
    assert names == [f"panel {DEMO.panel_name(p)}" for p in range(len(DEMO.mesh.faces))]
    assert names[0] == "panel 0,0"
    assert len(file.meshes) == len(names)
    assert all(material.doubleSided for material in file.materials)
    assert file.asset.extras == {"title": DEMO.title, "unit": DEMO.unit}


@pytest.mark.parametrize("family", FAMILIES)
def test_keys_turn_evenly_and_the_shorter_way(family: str, tmp_path: Path) -> None:
    """Unit quaternions within what single precision allows, no jump from q to -q."""
    scene = read(tmp_path, demo_document(family, size=SMALL))
    np.testing.assert_allclose(np.linalg.norm(scene.turns, axis=-1), 1.0, atol=2e-7)
    assert ((scene.turns[1:] * scene.turns[:-1]).sum(axis=-1) >= 0).all()


@pytest.mark.parametrize("family", FAMILIES)
def test_gaps_between_keys_are_as_small_as_said(family: str, tmp_path: Path) -> None:
    """Panels that meet in a vertex part by less than s²L/8: s is the largest turn, L the longest
    diagonal. That is of second order: with twice as many steps a quarter is left."""
    gaps = []
    for frames in (13, 25):
        document = demo_document(family, frames, SMALL)
        scene = read(tmp_path, document)
        faces = document.mesh.faces.ravel()
        worst = 0.0
        for time in (scene.times[1:] + scene.times[:-1]) / 2:
            corners = scene.corners(time).reshape(-1, 3)
            low = np.full((document.mesh.vertex_count, 3), np.inf)
            high = -low
            np.minimum.at(low, faces, corners)
            np.maximum.at(high, faces, corners)
            worst = max(worst, float(np.linalg.norm(high - low, axis=1).max()))
        gaps.append(worst)
        cosines = np.abs((scene.turns[1:] * scene.turns[:-1]).sum(axis=-1)).min()
        turn = 2 * np.arccos(min(cosines, 1.0))
        diagonal = np.linalg.norm(scene.shapes[:, 2:] - scene.shapes[:, :2], axis=-1).max()
        assert worst < turn**2 * diagonal / 8
    assert gaps[1] == pytest.approx(gaps[0] / 4, rel=0.1)


def test_times_follow_the_drive(tmp_path: Path) -> None:
    drives = np.array([state.drive_deg for state in DEMO.states], dtype=np.float64)
    np.testing.assert_allclose(read(tmp_path, DEMO).times, SECONDS * drives / drives[-1], atol=1e-6)
    nameless = tuple(DocumentState(state.positions) for state in DEMO.states)
    times = read(tmp_path, replace(DEMO, states=nameless)).times
    np.testing.assert_allclose(times, np.linspace(0, SECONDS, len(nameless)), atol=1e-6)


def test_flat_sheet_alone_does_not_move(tmp_path: Path) -> None:
    flat = flat_only(DEMO)
    scene = read(tmp_path, flat)
    assert not scene.file.animations
    expected = wanted(flat, flat.shell)
    assert np.abs(placed(scene.shapes, *scene.rest) - expected).max() < 1e-6 * size(expected)


def test_states_alone(tmp_path: Path) -> None:
    folded = folded_only(DEMO)
    scene = read(tmp_path, folded)
    assert len(scene.times) == len(DEMO.states) - 1
    assert scene.times[0] == 0
    expected = wanted(folded, folded.shell)
    assert np.abs(placed(scene.shapes, *scene.rest) - expected).max() < 1e-6 * size(expected)


def test_unit_must_be_known(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="this needs a unit of length"):
        read(tmp_path, replace(DEMO, unit="unit"))
    assert not list(tmp_path.iterdir())


def test_triangles_of_panels_with_and_without_a_corner_inwards(tmp_path: Path) -> None:
    """A dart and a square: triangles of one orientation, areas by hand."""
    flat = np.array([[0.0, 0], [4, 0], [4, 4], [3, 1], [4, -4], [0, -4]])
    document = replace(
        flat_only(DEMO),
        mesh=build_mesh(np.array([[0, 1, 2, 3], [0, 5, 4, 1]]), 6),
        flat=flat,
        grid_shape=None,
    )
    scene = read(tmp_path, document)
    blob, file = scene.file.binary_blob(), scene.file
    areas = []
    for mesh, shape in zip(file.meshes, scene.shapes, strict=True):
        entry = file.accessors[mesh.primitives[0].indices]
        begin = file.bufferViews[entry.bufferView].byteOffset + entry.byteOffset
        a, b, c = shape[np.frombuffer(blob, "<u2", 6, begin).reshape(2, 3)].transpose(1, 0, 2)
        areas.append(np.cross(b - a, c - a)[:, 2] / 2)
    assert (np.array(areas) > 0).all()
    np.testing.assert_allclose(np.sum(areas, axis=1), [4.0, 16.0], atol=1e-5)
