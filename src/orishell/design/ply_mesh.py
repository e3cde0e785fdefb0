"""Triangles of a PLY file, in text or binary.

G. Turk, The PLY Polygon File Format, Stanford University, 1994.
"""

from __future__ import annotations

import struct
from typing import Any, Final

import numpy as np

from orishell.design.mesh_errors import MeshFileError
from orishell.numerics.arrays import Array, Integers

LONGEST_HEAD: Final = 100_000
"""Bytes of the lines before the numbers, at most."""
MOST_ROWS: Final = 4_000_000
"""Vertices, faces or what else is listed, at most."""
KINDS: Final = {
    **{"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I"},
    **{"int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I"},
    **{"float": "f", "float32": "f", "double": "d", "float64": "d"},
}
ORDERS: Final = {"ascii": "=", "binary_little_endian": "<", "binary_big_endian": ">"}
LISTS: Final = ("vertex_indices", "vertex_index")
"""What programs call the corners of a face."""
Properties = dict[str, tuple[str, str]]
"""The kind of a number by name, and of the count of a list of such, or ""."""


def read_ply(data: bytes) -> tuple[Array, Integers]:
    """Vertices (V, 3) and triangles (T, 3) of a file by its bytes; polygons are cut into fans.

    Raises MeshFileError with what does not fit.
    """
    order, elements, body = _head(data)
    rows: dict[str, list[Any]] = {}
    at = 0
    for name, (count, properties) in elements.items():
        try:
            rows[name], at = _rows(body, at, order, count, list(properties.values()))
        except struct.error:
            what = f"{count} of element {name}"
            raise MeshFileError("", "a file that breaks off", what) from None
    try:
        vertex, face = elements["vertex"][1], elements["face"][1]
        x, y, z = (list(vertex).index(axis) for axis in "xyz" if not vertex[axis][1])
        listed = next(k for k, each in enumerate(face) if each in LISTS and face[each][1])
    except (KeyError, ValueError, StopIteration):
        got = "; ".join(f"{name}: {', '.join(each)}" for name, (_, each) in elements.items())
        expected = "vertex with x, y, z, and face with a list vertex_indices"
        raise MeshFileError("elements", got or "none", expected) from None
    points = np.array([(row[x], row[y], row[z]) for row in rows["vertex"]], np.float64)
    polygons = [row[listed] for row in rows["face"]]
    fans = [(p[0], p[k], p[k + 1]) for p in polygons for k in range(1, len(p) - 1)]
    triangles = np.array(fans, np.float64).reshape(-1, 3)
    if not (np.abs(triangles) < 2**53).all() or (triangles % 1).any():
        raise MeshFileError("element face", "a number that is not whole", "vertices")
    return points.reshape(-1, 3), triangles.astype(np.int64)


def _head(data: bytes) -> tuple[str, dict[str, tuple[int, Properties]], bytes]:
    """The order of bytes, elements by name, and their numbers; those of a text as doubles."""
    end = data.find(b"end_header", 0, LONGEST_HEAD)
    if not data.startswith(b"ply") or end < 0:
        raise MeshFileError("", data[:20], "ply, and a head that ends with end_header")
    order, elements = "", dict[str, tuple[int, Properties]]()
    properties: Properties = {}
    for number, line in enumerate(data[:end].decode("latin-1").splitlines(), start=1):
        match line.split():
            case ["format", kind, *_] if kind in ORDERS:
                order = kind
            case ["element", name, count] if (
                count.isdecimal() and int(count[:16]) <= MOST_ROWS and name not in elements
            ):
                properties = {}
                elements[name] = int(count), properties
            case ["property", "list", count, kind, name] if (
                KINDS.get(count, "f") not in "fd" and kind in KINDS and name not in properties
            ):
                properties[name] = KINDS[kind], KINDS[count]
            case ["property", kind, name] if kind in KINDS and name not in properties:
                properties[name] = KINDS[kind], ""
            case [("format" | "element" | "property"), *_]:
                raise MeshFileError(f"line {number}", line, f"a line of PLY, of {MOST_ROWS} rows")
    if not order:
        raise MeshFileError("", "no format", ", ".join(ORDERS))
    begin = end + len(b"end_header")
    body = data[begin + (2 if data[begin : begin + 2] == b"\r\n" else 1) :]
    if order == "ascii":
        try:
            values = np.array(body.split(), np.float64)
        except ValueError:
            raise MeshFileError("", "text among the numbers", "numbers only") from None
        if not np.isfinite(values).all():
            raise MeshFileError("", "a number that is none", "finite numbers")
        body = values.tobytes()
        for _, table in elements.values():
            table.update(
                {name: ("d", "d" if counted else "") for name, (_, counted) in table.items()}
            )
    return ORDERS[order], elements, body


def _rows(
    body: bytes, at: int, order: str, count: int, properties: list[tuple[str, str]]
) -> tuple[list[Any], int]:
    """Rows of an element that begins at a byte, a tuple for each list, and where it ends.

    Raises struct.error if the file breaks off before.
    """
    if not any(counted for _, counted in properties):
        form = struct.Struct(order + "".join(kind for kind, _ in properties))
        end = at + count * form.size
        if end > len(body):
            raise struct.error
        return list(form.iter_unpack(body[at:end])) if form.size else [], end
    rows = []
    for _ in range(count):
        row: list[Any] = []
        for kind, counted in properties:
            length = 1
            if counted:
                (given,) = struct.unpack_from(order + counted, body, at)
                length = int(given)
                if length != given:
                    raise MeshFileError("", f"a list of {given}", "lists of whole numbers of items")
                at += struct.calcsize(order + counted)
            values = struct.unpack_from(f"{order}{length}{kind}", body, at)
            at += struct.calcsize(f"{order}{length}{kind}")
            row.append(values if counted else values[0])
        rows.append(row)
    return rows, at
