"""Files of meshes of all kinds: the same surface, or refused with the place."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gltf_variants import SINGLE, Gltf, gltf_files
from mesh_variants import obj, obj_files, stl_files
from orishell.conventions.errors import InputError
from orishell.design import MeshSurface
from orishell.design.mesh_files import read_mesh
from ply_variants import ply_files
from vaulted_roof import AREA, POINTS, QUADS, TRIANGLES, Files

RARE = {"gltf, fans": "mode 6", "gltf, sparse": "sparse", "gltf, sparse without a base": "sparse"}
"""What is refused by name, since no program is known that writes roofs so."""
FILES = {**obj_files(), **ply_files(), **stl_files(), **gltf_files()}
VARIANTS = {name: files for name, files in FILES.items() if name not in RARE}


def written(files: Files, directory: Path) -> Path:
    """The first of some files."""
    for name, data in files.items():
        (directory / name).write_bytes(data)
    return directory / next(iter(files))


@pytest.mark.parametrize("name", VARIANTS)
def test_what_programs_write_is_read_as_what_it_means(name: str, tmp_path: Path) -> None:
    file = read_mesh(written(VARIANTS[name], tmp_path))
    surface = MeshSurface.of(file.vertices, file.triangles)
    assert surface.area() == pytest.approx(AREA, rel=1e-6)
    low, high = (each(surface.piece.vertices, axis=0) for each in (np.min, np.max))
    assert low == pytest.approx(POINTS.min(axis=0), abs=1e-4)  # what 16 bits leave of 4 m
    assert high == pytest.approx(POINTS.max(axis=0), abs=1e-4)


@pytest.mark.parametrize("name", RARE)
def test_what_is_rare_is_refused_by_name(name: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=RARE[name]) as refused:
        read_mesh(written(FILES[name], tmp_path))
    assert refused.value.remedy


def roof(change: Callable[[dict[str, Any]], object], **more: bytes) -> Files:
    """A good glTF file in which something was changed."""
    file = Gltf()
    file.add(SINGLE, "VEC3", 5126)
    file.add(TRIANGLES.astype("<u2").reshape(-1), "SCALAR", 5123)
    content = file.content([{"attributes": {"POSITION": 0}, "indices": 1}])
    found = file.inside(content)
    change(content)
    return {**found, "roof.gltf": json.dumps(content).encode(), **more}


def nodes(*entries: dict[str, Any]) -> Callable[[dict[str, Any]], object]:
    return lambda content: content.update(nodes=list(entries))


def primitive(**entries: Any) -> Callable[[dict[str, Any]], object]:
    return lambda content: content["meshes"][0]["primitives"][0].update(entries)


def entry(kind: str, number: int, **entries: Any) -> Callable[[dict[str, Any]], object]:
    return lambda content: content[kind][number].update(entries)


def mixed_kinds(content: dict[str, Any]) -> None:
    """Whole numbers that are normalized beside such that are not, in one mesh."""
    content["accessors"].append({**content["accessors"][0], "componentType": 5123, "count": 3})
    content["accessors"][2]["normalized"] = True
    content["meshes"][0]["primitives"].append({"attributes": {"POSITION": 2}})


SPARSE = {
    "count": 1,
    "indices": {"bufferView": 1, "componentType": 5123, "byteOffset": 100},
    "values": {"bufferView": 0},
}
HOSTILE: dict[str, tuple[Callable[[dict[str, Any]], object], str]] = {
    "a stride of nothing": (entry("bufferViews", 0, byteStride=0), "byteStride"),
    "a huge stride": (entry("bufferViews", 0, byteStride=2**62), "byteStride"),
    "a stride below nothing": (entry("bufferViews", 0, byteStride=-12), "byteStride"),
    "too many numbers": (entry("accessors", 0, count=2_000_000_000), "accessors[0].count"),
    "more than there are": (entry("accessors", 0, count=46), "size 135"),
    "a number that is true": (entry("accessors", 0, count=True), "vertices from 0 to 0"),
    "a number in a text": (entry("accessors", 0, count="45"), "TypeError"),
    "an offset below nothing": (entry("accessors", 0, byteOffset=-4), "byteOffset"),
    "an offset beyond": (entry("bufferViews", 0, byteOffset=10**9), "standard"),
    "a view beyond its buffer": (entry("bufferViews", 1, byteLength=10**6), "standard"),
    "no such buffer": (entry("bufferViews", 0, buffer=1), "standard"),
    "no such view": (entry("accessors", 0, bufferView=7), "standard"),
    "an unknown kind of number": (entry("accessors", 0, componentType=5124), "5124"),
    "vertices as pairs": (entry("accessors", 0, type="VEC2"), "standard"),
    "indices in single precision": (entry("accessors", 1, componentType=5126), "standard"),
    "normalized fractions": (entry("accessors", 0, normalized=True), "5126"),
    "no data": (lambda content: content["accessors"][0].pop("bufferView"), "no bufferView"),
    "sparse in a text": (entry("accessors", 0, sparse="all"), "sparse"),
    "sparse beyond": (entry("accessors", 0, sparse={**SPARSE, "count": 46}), "sparse"),
    "sparse without values": (
        entry("accessors", 0, sparse={**SPARSE, "values": None}),
        "sparse",
    ),
    "an index out of range": (
        entry("accessors", 0, count=10),
        "vertices from 0 to 9",
    ),
    "triangles of two": (entry("accessors", 1, count=190), "size 190"),
    "positions counted back": (primitive(attributes={"POSITION": -2}), "accessors[-2]"),
    "a view counted back": (entry("accessors", 0, bufferView=-2), "bufferView"),
    "a child counted back": (nodes({"children": [-1]}, {"mesh": 0}), "standard"),
    "a mesh counted back": (nodes({"mesh": -1}), "no triangles"),
    "nodes in nodes without end": (
        nodes(*({"children": [k + 1]} for k in range(5000)), {"mesh": 0}),
        "recursion",
    ),
    "a node in two places": (
        nodes({"children": [1, 2]}, {"children": [3]}, {"children": [3]}, {"mesh": 0}),
        "reached twice",
    ),
    "unlike kinds of numbers": (mixed_kinds, "unlike kinds"),
    "a file of views of all of it": (
        lambda content: content["bufferViews"].extend([{"byteLength": 10**8, "buffer": 0}] * 3),
        "together",
    ),
    "no positions": (primitive(attributes={}), "POSITION"),
    "attributes in a list": (primitive(attributes=[0]), "standard"),
    "an unknown mode": (primitive(mode=7), "mode"),
    "a node in itself": (nodes({"children": [0]}), "reached twice"),
    "nodes in a ring": (nodes({"children": [1]}, {"children": [0]}), "reached twice"),
    "nodes that double": (
        nodes(*({"children": [k + 1, k + 1]} for k in range(40)), {"mesh": 0}),
        "reached twice",
    ),
    "nodes in a number": (lambda content: content.update(nodes=7), "standard"),
    "a node in a list": (lambda content: content.update(nodes=[[]]), "standard"),
    "no such node": (nodes({"children": [5]}), "standard"),
    "no such mesh": (nodes({"mesh": 3}), "standard"),
    "a matrix of nine": (nodes({"mesh": 0, "matrix": [1] * 9}), "size 9"),
    "a skin": (nodes({"mesh": 0, "skin": 0}), "skin"),
    "a shape between shapes": (nodes({"mesh": 0, "weights": [0.5]}), "weights"),
    "copies by an extension": (
        nodes({"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {}}}),
        "EXT_mesh_gpu_instancing",
    ),
    "Draco": (
        lambda content: content.update(extensionsRequired=["KHR_draco_mesh_compression"]),
        "KHR_draco_mesh_compression",
    ),
    "meshopt": (
        entry("bufferViews", 0, extensions={"EXT_meshopt_compression": {}}),
        "EXT_meshopt_compression",
    ),
    "extensions in a text": (
        lambda content: content.update(extensionsRequired="a"),
        "extensionsRequired",
    ),
    "glTF 1": (lambda content: content.update(asset={"version": "1.0"}), "only GLTF 2"),
    "no such scene": (lambda content: content.update(scene=2), "standard"),
    "an address of nothing": (entry("buffers", 0, uri=None), "standard"),
    "an address that is none": (entry("buffers", 0, uri="data:nothing"), "a file beside"),
    "another folder": (entry("buffers", 0, uri="../roof.bin"), "a file beside"),
    "another folder, disguised": (entry("buffers", 0, uri="%2e%2e/roof.bin"), "a file beside"),
    "from the root": (entry("buffers", 0, uri="/dev/zero"), "a file beside"),
    "the network": (entry("buffers", 0, uri="http://localhost/roof.bin"), "a file beside"),
    "a zero in a name": (entry("buffers", 0, uri="a%00b.bin"), "embedded null"),
    "a missing buffer": (entry("buffers", 0, uri="none.bin"), "does not exist"),
    "a device": (entry("buffers", 0, uri="device.bin"), "this is not a file, a device"),
    "a folder": (entry("buffers", 0, uri="folder.bin"), "this is not a file, a directory"),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_gltf_that_would_do_harm_is_refused_by_place(name: str, tmp_path: Path) -> None:
    change, said = HOSTILE[name]
    (tmp_path / "device.bin").symlink_to("/dev/zero")
    (tmp_path / "folder.bin").mkdir()
    with pytest.raises(InputError) as refused:
        read_mesh(written(roof(change), tmp_path))
    assert said in str(refused.value)
    assert refused.value.keys == ("mesh",)
    assert refused.value.file == str(tmp_path / "roof.gltf")
    assert "\n" not in str(refused.value)
    assert len(str(refused.value)) < 1000


def test_a_mesh_that_is_shown_many_times_is_refused_before_it_is_made(tmp_path: Path) -> None:
    copies = nodes({"children": list(range(1, 17001))}, *[{"mesh": 0}] * 17000)
    with pytest.raises(InputError, match="at most 4000000"):
        read_mesh(written(roof(copies), tmp_path))  # 1,088,000 triangles


def test_a_scale_beyond_all_numbers_makes_no_surface(tmp_path: Path) -> None:
    file = read_mesh(written(roof(nodes({"mesh": 0, "scale": [1e300] * 3})), tmp_path))
    with pytest.raises(InputError, match="too large or too small"):
        MeshSurface.of(file.vertices, file.triangles)


GLB = b"glTF\2\0\0\0"
BROKEN: dict[str, tuple[str, bytes, str]] = {
    "a number of a vertex that is far too large": (
        "roof.obj",
        obj().encode() + b"f 1 2 99999999999999999999\n",
        "line 78",
    ),
    "a vertex that is not there": ("roof.obj", obj().encode() + b"f 1 2 46\n", "index 45"),
    "vertex 0": ("roof.obj", obj().encode() + b"f 0 1 2\n", "line 78"),
    "before the first vertex": ("roof.obj", obj().encode() + b"f -1 -2 -46\n", "line 78"),
    "a vertex in the plane": ("roof.obj", b"v 1 2\n" + obj().encode(), "line 1"),
    "a word for a number": ("roof.obj", obj().encode() + b"v 1 2 x\n", "line 78"),
    "no faces": ("roof.obj", obj([]).encode(), "no triangles"),
    "nothing": ("roof.obj", b"", "no triangles"),
    "no end of the head": ("roof.ply", b"ply\nformat ascii 1.0\nelement vertex 3\n", "end_header"),
    "no ply": ("roof.ply", b"solid", "expected ply"),
    "strips": (
        "roof.ply",
        b"ply\nformat ascii 1.0\nelement tristrips 1\n"
        b"property list int int vertex_indices\nend_header\n3 0 1 2\n",
        "tristrips",
    ),
    "more than fits": (
        "roof.ply",
        b"ply\nformat ascii 1.0\nelement vertex 999999999999\nend_header\n",
        "line 3",
    ),
    "a list of less than nothing": (
        "roof.ply",
        b"ply\nformat ascii 1.0\nelement face 1\nproperty list int int vertex_indices\n"
        b"end_header\n-3 0 1 2\n",
        "breaks off",
    ),
    "a face that is no list": (
        "roof.ply",
        b"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
        b"property float z\nelement face 1\nproperty int vertex_indices\nend_header\n0 0 0 0\n",
        "a list vertex_indices",
    ),
    "a list of heights": (
        "roof.ply",
        b"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
        b"property list int float z\nelement face 1\nproperty list int int vertex_indices\n"
        b"end_header\n0 0 1 0 3 0 0 0\n",
        "vertex with x, y, z",
    ),
    "a list of a half": (
        "roof.ply",
        b"ply\nformat ascii 1.0\nelement face 1\nproperty list int int vertex_indices\n"
        b"end_header\n2.5 0 1 2\n",
        "a list of 2.5",
    ),
    "words among numbers": (
        "roof.ply",
        b"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\nabc\n",
        "numbers only",
    ),
    "text that breaks off": (
        "roof.stl",
        b"solid a\nfacet\nvertex 0 0 0\n",
        "from solid to endsolid",
    ),
    "less than it counts": ("roof.stl", bytes(80) + b"\2\0\0\0" + bytes(50), "184 for the 2"),
    "more than it counts": ("roof.stl", bytes(80) + b"\1\0\0\0" + bytes(100), "134 for the 1"),
    "a list": ("roof.gltf", b"[1, 2]", "standard of glTF"),
    "no JSON": ("roof.gltf", b"{", "JSON"),
    "deep JSON": ("roof.gltf", b"[" * 100_000, "JSON"),
    "a part that is too long": (
        "roof.glb",
        GLB + bytes(4) + b"\xff\0\0\0JSON{}",
        "275: it breaks off",
    ),
    "an empty binary": ("roof.glb", GLB, "binary glTF 2.0"),
}


@pytest.mark.parametrize("name", BROKEN)
def test_broken_files_are_refused_by_place(name: str, tmp_path: Path) -> None:
    ending, data, said = BROKEN[name]
    with pytest.raises(InputError) as refused:
        read_mesh(written({ending: data}, tmp_path))
    assert said in str(refused.value)
    assert refused.value.file == str(tmp_path / ending)


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (ply, "breaks off")
        for name in ("text, mixed", "little, mixed", "big, quadrilaterals")
        for ply in [VARIANTS[f"ply, {name}"]["roof.ply"][:-40]]
    ],
)
def test_a_ply_file_that_breaks_off_is_refused(data: bytes, said: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=said):
        read_mesh(written({"roof.ply": data}, tmp_path))


@pytest.mark.parametrize("size", [1e160, 1e-160, np.inf, np.nan])
def test_coordinates_whose_squares_are_no_numbers_are_refused(size: float) -> None:
    with pytest.raises(InputError) as refused:
        MeshSurface.of(np.where(POINTS > 0, size, 0.0), TRIANGLES)
    assert refused.value.keys == ("mesh",)


def test_loose_vertices_do_not_count_in_the_size_of_a_mesh() -> None:
    """Vertices of the mesh are told apart by a share of its size."""
    far = np.concatenate([POINTS, [[1e9, 0, 0]]])
    assert MeshSurface.of(far, TRIANGLES).area() == pytest.approx(AREA, rel=1e-12)
    assert len(MeshSurface.of(far, TRIANGLES).piece.vertices) == len(POINTS)
    assert len(QUADS) * 2 == len(TRIANGLES)
