"""A roof in the ways in which programs write PLY: each means the same surface."""

from __future__ import annotations

import struct
from typing import Any

from vaulted_roof import HEXAGONS, MIXED, POINTS, QUADS, TRIANGLES, Files, np_lists


def _ply(
    faces: Any,
    order: str = "<",
    *,
    number: str = "float",
    index: tuple[str, str] = ("uchar", "int"),
    name: str = "vertex_indices",
    before: tuple[str, ...] = (),
    after: tuple[str, ...] = (),
    of_vertex: tuple[str, ...] = (),
    head: bytes = b"comment made by hand\n",
    elements: tuple[tuple[str, int, str, bytes], ...] = (),
    end: bytes = b"\n",
    early: bool = False,
) -> bytes:
    """A PLY file; ``order`` "" is text. Extra properties are uchar, each of them 7.

    Its remarks stand before its format if they are ``early``.
    """
    codes = {
        "float": "f",
        "double": "d",
        "uchar": "B",
        "int": "i",
        "uint": "I",
        "ushort": "H",
        "char": "b",
        "short": "h",
        "float32": "f",
        "uint8": "B",
        "int32": "i",
    }
    faces = np_lists(faces)
    kind = {"": "ascii", "<": "binary_little_endian", ">": "binary_big_endian"}[order]
    lines = [
        f"element vertex {len(POINTS)}",
        *(f"property {number} {each}" for each in "xyz"),
        *(f"property uchar {each}" for each in of_vertex),
        f"element face {len(faces)}",
        *(f"property uchar {each}" for each in before),
        f"property list {index[0]} {index[1]} {name}",
        *(f"property uchar {each}" for each in after),
    ]
    first = [text for where, _, text, _ in elements if where == "before"]
    last = [text for where, _, text, _ in elements if where == "after"]
    form = b"format " + kind.encode() + b" 1.0\n"
    content = b"ply\n" + (head + form if early else form + head)
    content += "".join(f"{line}\n" for line in [*first, *lines, *last, "end_header"]).encode()
    content = content.replace(b"\n", end)
    rows: list[tuple[str, list[float]]] = []
    for point in POINTS.tolist():
        rows.append((codes[number] * 3 + "B" * len(of_vertex), [*point, *[7] * len(of_vertex)]))
    for face in faces:
        pattern = "B" * len(before) + codes[index[0]] + codes[index[1]] * len(face)
        rows.append(
            (pattern + "B" * len(after), [*[7] * len(before), len(face), *face, *[7] * len(after)])
        )
    body = b""
    for pattern, values in rows:
        body += (
            struct.pack(order + pattern, *values)
            if order
            else " ".join(map(repr, values)).encode() + end
        )
    begin = b"".join(data for where, _, _, data in elements if where == "before")
    finish = b"".join(data for where, _, _, data in elements if where == "after")
    return content + begin + body + finish


def ply_files() -> dict[str, Files]:
    edge = "element edge 1\nproperty int vertex1\nproperty int vertex2"
    camera = "element camera 1\nproperty float view_px"
    found: dict[str, bytes] = {}
    for word, order in (("text", ""), ("little", "<"), ("big", ">")):
        found |= {
            f"{word}, triangles": _ply(TRIANGLES, order),
            f"{word}, quadrilaterals": _ply(QUADS, order),
            f"{word}, mixed": _ply(MIXED, order),
            f"{word}, mixed, the triangles first": _ply(MIXED[::-1], order),
            f"{word}, polygons of six": _ply(HEXAGONS, order),
            f"{word}, polygons of six and four": _ply([*HEXAGONS[:8], *QUADS[16:].tolist()], order),
            f"{word}, vertex_index": _ply(TRIANGLES, order, name="vertex_index"),
            f"{word}, double": _ply(QUADS, order, number="double", index=("uchar", "uint")),
            f"{word}, other names": _ply(QUADS, order, number="float32", index=("uint8", "int32")),
            f"{word}, short numbers": _ply(QUADS, order, number="float", index=("uint", "ushort")),
            f"{word}, colours": _ply(MIXED, order, of_vertex=("red", "green", "blue")),
            f"{word}, more of faces": _ply(MIXED, order, before=("flags",), after=("red", "green")),
            f"{word}, an edge": _ply(
                QUADS,
                order,
                elements=(
                    ("after", 1, edge, struct.pack(order + "ii", 0, 1) if order else b"0 1\n"),
                ),
            ),
            f"{word}, a camera": _ply(
                MIXED,
                order,
                elements=(("before", 1, camera, struct.pack(order + "f", 1) if order else b"1\n"),),
            ),
            f"{word}, like sizes on average": _ply([*MIXED[1:8], *MIXED[9:], HEXAGONS[0]], order),
            f"{word}, a remark before the format": _ply(QUADS, order, early=True),
            f"{word}, latin": _ply(
                QUADS, order, head="comment für\nobj_info ä\n".encode("latin-1")
            ),
        }
    found["text, carriage returns"] = _ply(QUADS, "", end=b"\r\n")
    return {f"ply, {name}": {"roof.ply": data} for name, data in found.items()}
