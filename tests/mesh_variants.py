"""A roof in the ways in which programs write OBJ and STL: each means the same surface.

Files are written here from the definitions of the formats, and share nothing with what reads them.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Callable
from typing import Any

import numpy as np

from vaulted_roof import HEXAGONS, MIXED, POINTS, QUADS, TRIANGLES, Files, np_lists


def _rows(points: np.ndarray, head: str = "v", join: str = " ") -> list[str]:
    return [join.join([head, *map(repr, point)]) for point in points.tolist()]


def obj(faces: Any = QUADS, word: Callable[[int], str] = str, *extra: str, base: int = 1) -> str:
    lines = [" ".join(["f", *(word(k + base) for k in face)]) for face in np_lists(faces)]
    return "\n".join([*_rows(POINTS), *extra, *lines, ""])


UV = ["vt 0 0", "vt 1 0", "vt 1 1"]
NORMALS = ["vn 0 0 1", "vn 0.1 0 0.9"]


def _negative(split: bool) -> str:
    """Vertices counted from the end so far; of each panel its own, if they are split."""
    if not split:
        return obj(QUADS, lambda k: str(k - len(POINTS) - 1))
    lines = []
    for quad in QUADS:
        lines += [*_rows(POINTS[quad]), "f -4 -3 -2 -1"]
    return "\n".join([*lines, ""])


def _objects() -> str:
    """Two objects, numbered through, with materials and a library that is not there."""
    lines = ["mtllib none.mtl", "o first", *_rows(POINTS), "usemtl a", "s 1"]
    half = len(QUADS) // 2
    faces = [" ".join(["f", *(f"{k + 1}/1/1" for k in quad)]) for quad in QUADS]
    return "\n".join(
        [
            *lines,
            *UV,
            *NORMALS,
            *faces[:half],
            "o second",
            "g x y",
            "usemtl b",
            "s off",
            *faces[half:],
            "usemtl a",
            "l 1 2",
            "p 1",
            "",
        ]
    )


def _wrapped(blank: str) -> str:
    text = obj()
    return "\n".join(
        line if not line.startswith("f") else line.replace(" ", f"{blank}\\\n ", 3)
        for line in text.split("\n")
    )


def _colour(text: str) -> str:
    return "\n".join(
        f"{line} 0.5 0.5 {k % 2}" if line.startswith("v ") else line
        for k, line in enumerate(text.split("\n"))
    )


def obj_files() -> dict[str, Files]:
    texts = {
        "triangles": obj(TRIANGLES),
        "quadrilaterals": obj(),
        "mixed": obj(MIXED),
        "polygons of six": obj(HEXAGONS),
        "uv": obj(QUADS, lambda k: f"{k}/{k % 3 + 1}", *UV),
        "uv and normals": obj(QUADS, lambda k: f"{k}/{k % 3 + 1}/{k % 2 + 1}", *UV, *NORMALS),
        "uv and normals, mixed": obj(
            MIXED, lambda k: f"{k}/{k % 3 + 1}/{k % 2 + 1}", *UV, *NORMALS
        ),
        "normals": obj(QUADS, lambda k: f"{k}//{k % 2 + 1}", *NORMALS),
        "normals of all vertices": obj(QUADS, lambda k: f"{k}//{k}", *["vn 0 0 1"] * len(POINTS)),
        "colours": _colour(obj()),
        "colours of some": _colour(obj()).replace(" 0.5 0.5 0\n", "\n"),
        "weights": "\n".join(f"{x} 1.0" if x[:2] == "v " else x for x in obj().split("\n")),
        "negative": _negative(False),
        "negative, panel by panel": _negative(True),
        "wrapped": _wrapped(" "),
        "wrapped without a blank": _wrapped(""),
        "tabs": obj().replace(" ", "\t"),
        "indented": "\n".join(f"  {line}" for line in obj().split("\n")),
        "blanks": obj().replace(" ", "   ").replace("\n", "  \n"),
        "carriage returns": obj().replace("\n", "\r\n"),
        "remarks": "# roof\n\n" + obj().replace("\nf ", " # here\nf ").replace("3\n", "3 # 1 2\n"),
        "no line at the end": obj().rstrip("\n"),
        "exponents": "\n".join(
            [
                *(f"v {x:.7e} {y:+.7E} {z:.7e}" for x, y, z in POINTS),
                *obj().split("\n")[len(POINTS) :],
            ]
        ),
        "objects and materials": _objects(),
        "faces of two vertices": obj() + "f 1 2\n",
        "loose vertices": obj() + "v 1e9 0 0\nv 0 1e9 0\n",
        "unused normals": obj() + "vn 0 0 1\nvn 0 1 0\n",
        "returns without new lines": obj().replace("\n", "\r"),
    }
    files = {name: {"roof.obj": text.encode()} for name, text in texts.items()}
    files["latin"] = {"roof.obj": "# Kuppel über der Straße\n".encode("latin-1") + obj().encode()}
    files["byte order mark"] = {"roof.obj": b"\xef\xbb\xbf" + obj().encode()}
    return {f"obj, {name}": each for name, each in files.items()}


def _stl_text(triangles: np.ndarray = TRIANGLES, name: str = "roof") -> str:
    facets = [
        "facet normal 0 0 0\n outer loop\n"
        + "".join(f"  vertex {x:e} {y:e} {z:e}\n" for x, y, z in POINTS[t])
        + " endloop\nendfacet\n"
        for t in triangles
    ]
    return f"solid {name}\n" + "".join(facets) + f"endsolid {name}\n"


def _stl_binary(head: bytes = b"roof", colour: int = 0) -> bytes:
    rows = [
        struct.pack("<3f", 0, 0, 0) + POINTS[t].astype("<f4").tobytes() + struct.pack("<H", colour)
        for t in TRIANGLES
    ]
    return head.ljust(80) + struct.pack("<I", len(rows)) + b"".join(rows)


def stl_files() -> dict[str, Files]:
    half = len(TRIANGLES) // 2
    found = {
        "text": _stl_text().encode(),
        "capitals": _stl_text().upper().encode(),
        "tabs": _stl_text().replace("\n ", "\n\t").encode(),
        "carriage returns": _stl_text().replace("\n", "\r\n").encode(),
        "no name": _stl_text(name="").encode(),
        "facets in a line": re.sub(r"\n(?! *facet|endsolid)", " ", _stl_text()).encode(),
        "returns without new lines": _stl_text().replace("\n", "\r").encode(),
        "a name with words of the format": _stl_text(name="vertex normal facet 3").encode(),
        "latin": _stl_text(name="Straße").encode("latin-1"),
        "two solids": (_stl_text(TRIANGLES[:half]) + _stl_text(TRIANGLES[half:], "b")).encode(),
        "binary": _stl_binary(),
        "binary that begins as text": _stl_binary(b"solid roof"),
        "binary with colours": _stl_binary(b"COLOR=abcd", 0x8123),
    }
    return {f"stl, {name}": {"roof.stl": data} for name, data in found.items()}
