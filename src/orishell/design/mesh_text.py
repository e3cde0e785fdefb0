"""OBJ and STL files as the library of meshes reads them without a mistake.

trimesh takes numbers that count back in OBJ from the last vertex of all, not from the last so far,
vertex 0 for vertex 1, and an STL name for what it says; and leaves out what it does not know.
Wavefront Technologies, Advanced Visualizer, appendix B1; 3D Systems, StereoLithography Interface
Specification, 1988.
"""

from __future__ import annotations

import re

from orishell.design.mesh_errors import MeshFileError, text_of

MOST_ELEMENTS = 4_000_000
"""Vertices, and triangles, of an OBJ file, at most."""
HEAD, RECORD = 84, 50
"""Bytes of a binary STL file before its triangles, and of each."""
_SOLID = re.compile(r"^[ \t]*((?:end)?solid)\b.*$", re.IGNORECASE | re.MULTILINE)
_WORDS = re.compile(r"\s+(?=facet|outer|vertex|end)", re.IGNORECASE)
_VERTEX = re.compile(r"\nvertex(?:\s+[^\s]+){3}\s*(?=\n)", re.IGNORECASE)


def plain_obj(data: bytes) -> tuple[bytes, int]:
    """Vertices and faces of a file, numbered from 1, and how many triangles they make.

    Normals, texture coordinates, colours, weights, groups, materials, points and lines are left
    out. Raises MeshFileError with the line that does not fit.
    """
    lines = []
    vertices = triangles = 0
    whole = ""
    for number, line in enumerate(re.split(r"\r\n?|\n", text_of(data)), start=1):
        whole += line.partition("#")[0].rstrip()
        if whole.endswith("\\"):
            whole = whole[:-1] + " "
            continue
        words, whole = whole.split(), ""
        if max(vertices, triangles) > MOST_ELEMENTS:
            raise MeshFileError(
                f"line {number}", "more vertices or triangles", f"{MOST_ELEMENTS} at most"
            )
        try:
            if words[:1] == ["v"]:
                x, y, z = map(float, words[1:4])
                vertices += 1
                lines.append(f"v {x!r} {y!r} {z!r}")
            elif words[:1] == ["f"] and len(words) > 3:  # else it has no area
                triangles += len(words) - 3
                lines.append("f " + " ".join(_counted(word, vertices) for word in words[1:]))
        except ValueError:
            kind = "v and three numbers" if words[0] == "v" else "f and numbers of vertices, not 0"
            raise MeshFileError(f"line {number}", " ".join(words), kind) from None
    return "\n".join([*lines, ""]).encode(), triangles


def _counted(word: str, before: int) -> str:
    """The vertex that a corner of a face names, as in 3, 3/1, 3//2 or -1, counted from 1."""
    number = int(word.partition("/")[0])
    if number == 0 or not -before <= number < 2**31:
        raise ValueError
    return str(number if number > 0 else before + 1 + number)


def plain_stl(data: bytes) -> tuple[bytes, int]:
    """A file whose names are none, each vertex in its line, and how many triangles it says.

    Raises MeshFileError if it breaks off.
    """
    count = int.from_bytes(data[HEAD - 4 : HEAD], "little")
    if len(data) == HEAD + count * RECORD:
        return data, count
    text = text_of(data).replace("\r", "\n")
    ends = [each.lower() for each in _SOLID.findall(text)]
    if not ends or ends != ["solid", "endsolid"] * (len(ends) // 2):
        size = f"{HEAD + count * RECORD} for the {count} triangles that it counts"
        raise MeshFileError("", f"{len(data)} bytes", f"{size}, or text from solid to endsolid")
    text = _WORDS.sub("\n", _SOLID.sub(r"\1", text))
    vertices = text.lower().count("vertex")
    if vertices % 3 or vertices != len(_VERTEX.findall(text)):
        raise MeshFileError("", f"{vertices} vertices", "three of a triangle, each three numbers")
    return text.encode(), vertices // 3
