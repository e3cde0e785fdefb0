"""glTF 2.0 files as the library of meshes reads them without a mistake.

trimesh passes over normalized and sparse numbers, fans, files without a scene, nodes with a camera
and what bends a mesh, takes one of two places of a node, and numbers of any size. Khronos Group,
glTF 2.0 Specification, 2021; KHR_mesh_quantization for positions in whole numbers.
"""

from __future__ import annotations

from pathlib import Path, PurePosixPath
from typing import Any, Final
from urllib.parse import unquote

from orishell.conventions.errors import InputError
from orishell.conventions.source_file import read_source_file
from orishell.design.mesh_errors import MeshFileError

TRIANGLES, FAN = 4, 6
LARGEST_INTEGERS: Final = {5120: 127, 5121: 255, 5122: 32767, 5123: 65535}
"""What stands for 1 in whole numbers that are normalized, by their kind."""
MOST_CORNERS: Final = 4_000_000
"""Positions and corners of all that is shown, at most; accessors have four times as many."""
MOST_NODES: Final = 100_000
LIMITS: Final = {"byteStride": (1, 252), "count": (1, MOST_CORNERS)}
"""Of numbers of accessors and views; others are from 0."""
KNOWN: Final = ("KHR_mesh_quantization", "KHR_animation_pointer", "KHR_xmp_json_ld")
LOOKS: Final = ("KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_lights_")
"""Extensions that may be needed, and how those begin that change looks only."""


class Buffers:
    """The buffers of a file by their addresses, if they are files beside it of ``left`` bytes."""

    def __init__(self, directory: Path, left: int, inside: bytes) -> None:
        self._directory, self._left, self._inside = directory, left, inside

    def __getitem__(self, uri: str) -> bytes:
        """Bytes of a buffer; "" is the one in the file. Raises MeshFileError if it is none."""
        if not uri:
            return self._inside
        name = unquote(uri)
        outside = name.startswith("/") or ".." in PurePosixPath(name).parts
        _require(not outside and not {":", "\\"} & {*name}, "buffers", uri, "a file beside it")
        try:
            found = read_source_file(self._directory / name, "buffer", self._left)
        except InputError as error:
            got = ", ".join(filter(None, (name, error.what, error.got)))
            raise MeshFileError("buffers", got, "a file beside it") from None
        self._left -= len(found)
        return found


def plain_gltf(data: bytes, directory: Path, most: int) -> tuple[bytes, Buffers]:
    """The shapes of a .gltf or .glb file as .gltf, and its buffers of ``most`` bytes.

    What whole numbers of a mesh are divided by is its ``extras.divisor``. Raises MeshFileError with
    what does not fit.
    """
    import orjson

    try:
        text, binary = _parts(data)
        content = orjson.loads(text)
        _keep_shapes(content, 2 * most)
        return orjson.dumps(content), Buffers(directory, most, binary)
    except (LookupError, TypeError, AttributeError, ValueError) as error:
        got = f"{type(error).__name__}: {error}".removesuffix(": ")
        raise MeshFileError("", got, "what the standard of glTF 2.0 says") from None


def _require(good: bool, where: str, got: object, expected: str) -> None:
    if not good:
        raise MeshFileError(where, got, expected)


def _parts(data: bytes) -> tuple[bytes, bytes]:
    """The JSON and the binary chunk of a file."""
    if data[:4] != b"glTF":
        return data.removeprefix(b"\xef\xbb\xbf"), b""
    parts: dict[bytes, bytes] = {}
    begin = 12
    while begin + 8 <= len(data):
        end = begin + 8 + int.from_bytes(data[begin : begin + 4], "little")
        _require(end <= len(data), f"byte {begin}", f"{len(data)} bytes", f"{end}: it breaks off")
        parts.setdefault(data[begin + 4 : begin + 8], data[begin + 8 : end])
        begin = end
    _require(b"JSON" in parts and data[4] == 2, "byte 4", data[4:20], "binary glTF 2.0")
    return parts[b"JSON"], parts.get(b"BIN\0", b"")


def _keep_shapes(content: Any, most: int) -> None:
    """Refuse what would be read wrongly, and leave out what is no shape."""
    for kind in ("accessors", "bufferViews", "buffers", "meshes", "nodes"):
        content.setdefault(kind, [])
    for name in content.get("extensionsRequired", []):
        known = name in KNOWN or name.startswith(LOOKS)
        _require(known, "extensionsRequired", name, f"none that shapes need but {KNOWN[0]}")
    for kind in ("accessors", "bufferViews"):
        for number, table in enumerate(content[kind]):
            for key, value in table.items():
                low, high = LIMITS.get(key, (0, 2**53))
                good = type(value) is not int or low <= value <= high
                _require(good, f"{kind}[{number}].{key}", value, f"a number from {low} to {high}")
    for kind, key, limit in (
        ("bufferViews", "byteLength", most),
        ("accessors", "count", 4 * MOST_CORNERS),
    ):
        size = sum(each[key] for each in content[kind])
        _require(size <= limit, kind, f"{key} {size} together", f"at most {limit}")
    for buffer in content["buffers"]:
        buffer.setdefault("uri", "")
    nodes = content["nodes"]
    inner = [child for node in nodes for child in node.get("children", [])]
    if "scenes" not in content:
        content |= {"scene": 0, "scenes": [{"nodes": sorted({*range(len(nodes))} - {*inner})}]}
    reached = [*content["scenes"][content.get("scene", 0)].get("nodes", []), *inner]
    twice = len({*reached}) < len(reached)
    _require(not twice, "nodes", "a node that is reached twice", "nodes that make a tree")
    _require(len(nodes) <= MOST_NODES, "nodes", len(nodes), f"at most {MOST_NODES}")
    sizes = [_keep_triangles(content, number) for number in range(len(content["meshes"]))]
    shown = sum(sizes)
    for number, node in enumerate(nodes):
        node.pop("camera", None)
        if "mesh" in node:
            flaws = ["skin"] * ("skin" in node) + ["weights"] * any(node.get("weights", []))
            flaws += [key for key in node.get("extensions", {}) if key == "EXT_mesh_gpu_instancing"]
            _require(not flaws, f"nodes[{number}]", flaws, "a mesh that nothing bends or copies")
            shown += sizes[node["mesh"]]
            if not sizes[node["mesh"]]:
                del node["mesh"]
    _require(
        shown <= MOST_CORNERS, "nodes", f"{shown} positions and corners", f"at most {MOST_CORNERS}"
    )


def _keep_triangles(content: Any, number: int) -> int:
    """Leave out points and lines of a mesh; how many positions and corners it has then."""
    mesh, where = content["meshes"][number], f"meshes[{number}]"
    _require(not any(mesh.get("weights", [])), where, "weights", "a mesh that nothing bends")
    accessors, views = content["accessors"], content["bufferViews"]
    kept, divisors, size = [], set[int](), 0
    for each in mesh["primitives"]:
        mode = each.get("mode", TRIANGLES)
        _require(mode in range(FAN), where, f"mode {mode}", "triangles, or strips of them")
        if mode < TRIANGLES:
            continue
        shape = {key: each[key] for key in ("mode", "indices") if key in each}
        position = each["attributes"]["POSITION"]
        for index in (position, shape.get("indices", position)):
            accessor, place = accessors[index], f"accessors[{index}]"
            view = views[accessor["bufferView"]] if "bufferView" in accessor else None
            flaws = ["no bufferView"] if view is None else [*view.get("extensions", {})]
            flaws += [key for key in accessor if key == "sparse"]
            _require(
                index >= 0 and not flaws, place, flaws, "neither sparse nor compressed numbers"
            )
            size += accessor["count"]
        points = accessors[position]
        divisors.add(LARGEST_INTEGERS[points["componentType"]] if points.get("normalized") else 1)
        kept.append({"attributes": {"POSITION": position}, **shape})
    _require(len(divisors) < 2, where, "unlike kinds of numbers", "one kind in each mesh")
    content["meshes"][number] = {
        "primitives": kept,
        "extras": {"divisor": max(divisors, default=1)},
    }
    return size
