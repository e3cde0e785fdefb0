"""A roof in the ways in which programs write glTF: each means the same surface."""

from __future__ import annotations

import base64
import json
import struct
from typing import Any

import numpy as np

from vaulted_roof import NUMBERS, POINTS, QUADS, ROWS, TRIANGLES, Files


class Gltf:
    """A glTF file as it grows: y up, in metres."""

    def __init__(self) -> None:
        self.data = b""
        self.views: list[dict[str, Any]] = []
        self.accessors: list[dict[str, Any]] = []

    def view(self, data: bytes, **more: Any) -> int:
        self.data += b"\0" * (-len(self.data) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)})
        self.views[-1] |= more
        self.data += data
        return len(self.views) - 1

    def add(self, values: np.ndarray, kind: str, component: int, **more: Any) -> int:
        entry = {
            "bufferView": self.view(values.tobytes()),
            "componentType": component,
            "count": len(values),
            "type": kind,
        }
        self.accessors.append(entry | more)
        return len(self.accessors) - 1

    def content(self, primitives: Any, nodes: Any = None, **more: Any) -> dict[str, Any]:
        return {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": nodes or [{"mesh": 0}],
            "meshes": [{"primitives": primitives}],
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"byteLength": len(self.data)}],
        } | more

    def inside(self, content: dict[str, Any]) -> Files:
        text = base64.b64encode(self.data).decode()
        content["buffers"][0]["uri"] = f"data:application/octet-stream;base64,{text}"
        return {"roof.gltf": json.dumps(content).encode()}

    def beside(self, content: dict[str, Any], uri: str, name: str) -> Files:
        content["buffers"][0]["uri"] = uri
        return {"roof.gltf": json.dumps(content).encode(), name: self.data}

    def binary(self, content: dict[str, Any]) -> Files:
        text = json.dumps(content).encode()
        text += b" " * (-len(text) % 4)
        data = self.data + b"\0" * (-len(self.data) % 4)
        chunks = struct.pack("<I4s", len(text), b"JSON") + text
        chunks += struct.pack("<I4s", len(data), b"BIN\0") + data
        return {"roof.glb": struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks}


UP = np.stack([POINTS[:, 0], POINTS[:, 2], -POINTS[:, 1]], axis=-1)
SINGLE = UP.astype("<f4")


def _strips() -> np.ndarray:
    """Rows of the vault in one strip, joined by triangles of no area."""
    found: list[int] = []
    for row in range(ROWS):
        pairs = np.stack([NUMBERS[row + 1], NUMBERS[row]], axis=-1).ravel().tolist()
        found += [*([found[-1], pairs[0]] if found else []), *pairs]
    return np.array(found)


def _plain(index: tuple[int, str] = (5123, "<u2")) -> tuple[Gltf, list[dict[str, Any]]]:
    file = Gltf()
    position = file.add(SINGLE, "VEC3", 5126)
    numbers = file.add(TRIANGLES.astype(index[1]).reshape(-1), "SCALAR", index[0])
    return file, [{"attributes": {"POSITION": position}, "indices": numbers}]


def _whole(component: int, kind: str, normalized: bool, required: bool = True) -> Files:
    """Positions in whole numbers, put back by the node: KHR_mesh_quantization."""
    info = np.iinfo(kind)
    low, high = UP.min(axis=0), UP.max(axis=0)
    if normalized:  # from 0 or -1 to 1
        least = -1.0 if info.min < 0 else 0.0
        scale = (high - low) / (1 - least)
        middle = low - least * scale
        values = np.round((UP - middle) / scale * info.max)
    else:
        scale = (high - low) / (int(info.max) - int(info.min))
        middle = low - info.min * scale
        values = np.round((UP - middle) / scale)
    padded = np.zeros((len(values), 4), kind)
    padded[:, :3] = values
    file = Gltf()
    view = file.view(padded.tobytes(), byteStride=padded.strides[0])
    file.accessors.append(
        {
            "bufferView": view,
            "componentType": component,
            "count": len(values),
            "type": "VEC3",
            "normalized": normalized,
        }
    )
    numbers = file.add(TRIANGLES.astype("<u2").reshape(-1), "SCALAR", 5123)
    node = {"mesh": 0, "scale": scale.tolist(), "translation": middle.tolist()}
    needs = {"extensionsUsed": ["KHR_mesh_quantization"]}
    needs |= {"extensionsRequired": ["KHR_mesh_quantization"]} if required else {}
    return file.inside(
        file.content([{"attributes": {"POSITION": 0}, "indices": numbers}], [node], **needs)
    )


def _sparse(base: bool) -> Files:
    """The heights of all vertices are replaced, or all vertices where there is no base."""
    file, at = Gltf(), np.arange(len(UP)) if not base else np.flatnonzero(UP[:, 1] != 0.5)
    flat = SINGLE.copy()
    flat[at, 1] = 0
    indices, values = file.view(at.astype("<u2").tobytes()), file.view(SINGLE[at].tobytes())
    sparse = {
        "count": len(at),
        "indices": {"bufferView": indices, "componentType": 5123},
        "values": {"bufferView": values},
    }
    entry = {"componentType": 5126, "count": len(UP), "type": "VEC3", "sparse": sparse}
    file.accessors.append(entry | ({"bufferView": file.view(flat.tobytes())} if base else {}))
    numbers = file.add(TRIANGLES.astype("<u2").reshape(-1), "SCALAR", 5123)
    return file.binary(file.content([{"attributes": {"POSITION": 0}, "indices": numbers}]))


def _halves(file: Gltf) -> dict[str, Any]:
    """One half of the vault, and the same mirrored by its node."""
    right = POINTS[QUADS][..., 0].min(axis=1) >= 0
    half = TRIANGLES[np.tile(right, 2)]
    numbers = file.add(half.astype("<u2").reshape(-1), "SCALAR", 5123)
    nodes = [{"children": [1, 2]}, {"mesh": 0}, {"mesh": 0, "scale": [-1, 1, 1]}]
    return file.content([{"attributes": {"POSITION": 0}, "indices": numbers}], nodes)


def gltf_files() -> dict[str, Files]:
    found: dict[str, Files] = {}
    for name, index in {
        "bytes": (5121, "u1"),
        "shorts": (5123, "<u2"),
        "whole": (5125, "<u4"),
    }.items():
        file, primitives = _plain(index)
        found[f"indices in {name}"] = file.inside(file.content(primitives))
    file, primitives = _plain()
    found["binary"] = file.binary(file.content(primitives))
    file, primitives = _plain()
    found["a buffer beside"] = file.beside(file.content(primitives), "roof.bin", "roof.bin")
    file, primitives = _plain()
    found["a blank in the name"] = file.beside(
        file.content(primitives), "my%20roof.bin", "my roof.bin"
    )
    file, primitives = _plain()
    found["no scene"] = file.binary(
        {k: v for k, v in file.content(primitives).items() if not k.startswith("scene")}
    )
    file = Gltf()
    file.add(SINGLE[TRIANGLES].reshape(-1, 3), "VEC3", 5126)
    found["no indices"] = file.binary(file.content([{"attributes": {"POSITION": 0}}]))
    for mode, name, runs in ((5, "a strip", [_strips()]), (6, "fans", list(QUADS))):
        file = Gltf()
        file.add(SINGLE, "VEC3", 5126)
        primitives = [
            {
                "attributes": {"POSITION": 0},
                "mode": mode,
                "indices": file.add(run.astype("<u2"), "SCALAR", 5123),
            }
            for run in runs
        ]
        found[name] = file.binary(file.content(primitives))
    file = Gltf()
    together = np.zeros((len(SINGLE), 8), "<f4")
    together[:, 3:6], together[:, 4], together[:, :3] = 0, 1, SINGLE
    view = file.view(together.tobytes(), byteStride=32)
    for offset, kind in ((0, "VEC3"), (12, "VEC3"), (24, "VEC2")):
        file.accessors.append(
            {
                "bufferView": view,
                "byteOffset": offset,
                "componentType": 5126,
                "count": len(SINGLE),
                "type": kind,
            }
        )
    numbers = file.add(TRIANGLES.astype("<u2").reshape(-1), "SCALAR", 5123)
    found["interleaved"] = file.binary(
        file.content(
            [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": numbers}]
        )
    )
    found |= {
        "normalized unsigned shorts": _whole(5123, "<u2", True),
        "normalized shorts": _whole(5122, "<i2", True),
        "shorts": _whole(5122, "<i2", False),
        "unsigned shorts": _whole(5123, "<u2", False, required=False),
        "sparse": _sparse(True),
        "sparse without a base": _sparse(False),
    }
    file, primitives = _plain()
    turn = [0, 0, float(np.sin(0.3)), float(np.cos(0.3))]
    back = [0, 0, float(-np.sin(0.3)), float(np.cos(0.3))]
    nodes = [
        {"children": [1], "rotation": turn, "scale": [2, 2, 2], "name": "a"},
        {"children": [2], "rotation": back, "name": "a"},
        {"mesh": 0, "matrix": [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]},
    ]
    found["nodes in nodes"] = file.binary(file.content(primitives, nodes))
    file = Gltf()
    file.add(SINGLE, "VEC3", 5126)
    found["a mesh twice, mirrored"] = file.binary(_halves(file))
    file, primitives = _plain()
    lines = [{"attributes": {"POSITION": 0}, "mode": mode} for mode in (0, 1, 2, 3)]
    found["points and lines as well"] = file.binary(file.content([*lines, *primitives]))
    file, primitives = _plain()
    content = file.content(primitives, [{"mesh": 1, "children": [1], "translation": [0, 0, 9]}])
    content["nodes"].append({"mesh": 0, "translation": [0, 0, -9]})
    content["meshes"].append({"primitives": lines[1:2]})
    found["a mesh in a node of lines"] = file.binary(content)
    file, primitives = _plain()
    chain = [{"children": [k + 1], "name": "a"} for k in range(200)]
    found["nodes two hundred deep"] = file.binary(file.content(primitives, [*chain, {"mesh": 0}]))
    file, primitives = _plain()
    camera = {"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}
    found["a camera in the same node"] = file.binary(
        file.content(primitives, [{"mesh": 0, "camera": 0}], cameras=[camera])
    )
    file, primitives = _plain()
    found["materials that are extended"] = file.binary(
        file.content(
            primitives,
            extensionsUsed=["KHR_materials_unlit"],
            extensionsRequired=["KHR_materials_unlit", "KHR_texture_transform"],
        )
    )
    return {f"gltf, {name}": each for name, each in found.items()}
