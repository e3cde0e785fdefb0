"""Triangles of a glTF 2.0 file: of all meshes of its scene, where their nodes put them.

Khronos Group, glTF 2.0 Specification: its y points up, and its unit is the metre; here z points up.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from orishell.conventions.errors import InputError
from orishell.numerics.arrays import Array, Integers

TYPES: dict[int, np.dtype[Any]] = {
    5121: np.dtype("<u1"),
    5123: np.dtype("<u2"),
    5125: np.dtype("<u4"),
    5126: np.dtype("<f4"),
}
TRIANGLES = 4
DEEPEST = 100
"""Nodes in nodes, at most."""


def read_gltf(path: Path) -> tuple[Array, Integers]:
    """Vertices (V, 3), z up, and triangles (T, 3) of a .gltf or .glb file.

    Raises
    ------
    InputError
        If they cannot be read.
    """
    try:
        content, binary = _parts(path.read_bytes())
        buffers = [
            binary if "uri" not in each else _data(each["uri"], path.parent)
            for each in content.get("buffers", [])
        ]
        scene = content["scenes"][content.get("scene", 0)]
        found = [
            part
            for node in scene.get("nodes", [])
            for part in _of_node(content, buffers, node, np.eye(4), 0)
        ]
    except (OSError, ValueError, KeyError, IndexError, TypeError, RecursionError) as error:
        raise InputError(
            "the file holds no mesh that can be read",
            file=path,
            keys=("mesh",),
            where="mesh",
            got=f"{type(error).__name__}: {error}"[:80],
            expected="glTF 2.0 with triangles that are not compressed",
        ) from None
    if not found:
        return np.zeros((0, 3)), np.zeros((0, 3), np.int64)
    starts = np.cumsum([0, *(len(points) for points, _ in found)])
    vertices = np.concatenate([points for points, _ in found])
    triangles = [start + each for start, (_, each) in zip(starts[:-1], found, strict=True)]
    x, y, z = vertices.T
    return np.stack([x, -z, y], axis=-1), np.concatenate(triangles)


def _parts(data: bytes) -> tuple[Any, bytes]:
    """The JSON and the binary chunk of a file."""
    if data[:4] != b"glTF":
        return json.loads(data), b""
    size = int.from_bytes(data[12:16], "little")
    return json.loads(data[20 : 20 + size]), data[28 + size :]


def _data(uri: str, directory: Path) -> bytes:
    if uri.startswith("data:"):
        return base64.b64decode(uri.partition(",")[2])
    if Path(uri).name != uri:
        raise ValueError("buffers lie beside the file")
    return (directory / uri).read_bytes()


def _of_node(
    content: Any, buffers: list[bytes], number: int, above: Array, depth: int
) -> Iterator[tuple[Array, Integers]]:
    if depth > DEEPEST:
        raise ValueError("nodes are nested too deeply")
    node = content["nodes"][number]
    place = above @ _matrix(node)
    primitives = content["meshes"][node["mesh"]]["primitives"] if "mesh" in node else []
    for each in primitives:
        if each.get("mode", TRIANGLES) != TRIANGLES:
            continue
        points = _accessor(content, buffers, each["attributes"]["POSITION"]).astype(np.float64)
        numbers = (
            _accessor(content, buffers, each["indices"]).astype(np.int64)
            if "indices" in each
            else np.arange(len(points))
        )
        yield points @ place[:3, :3].T + place[:3, 3], numbers.reshape(-1, 3)
    for child in node.get("children", []):
        yield from _of_node(content, buffers, child, place, depth + 1)


def _matrix(node: Any) -> Array:
    """Where a node puts its meshes: a matrix (4, 4)."""
    if "matrix" in node:
        return np.array(node["matrix"], np.float64).reshape(4, 4).T
    x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
    rotation = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    made = np.eye(4)
    made[:3, :3] = rotation * np.array(node.get("scale", (1.0, 1.0, 1.0)))
    made[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
    return made


def _accessor(content: Any, buffers: list[bytes], number: int) -> Any:
    """The numbers of an accessor: (N, 3) or (N,)."""
    accessor = content["accessors"][number]
    view = content["bufferViews"][accessor["bufferView"]]
    kind: np.dtype[Any] = TYPES[accessor["componentType"]]
    width = {"SCALAR": 1, "VEC3": 3}[accessor["type"]]
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    stride = view.get("byteStride", width * kind.itemsize)
    found = np.ndarray(
        (accessor["count"], width), kind, buffers[view["buffer"]], start, (stride, kind.itemsize)
    )
    return found if width > 1 else found[:, 0]
