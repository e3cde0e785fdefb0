"""One state of the shell as binary STL."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from orishell.document import Document
from orishell.io.format import Format, Settings
from orishell.io.solids import find_surface, split_panels
from orishell.numerics.arrays import Array

HEADER_LENGTH = 80

_RECORD = np.dtype([("normal", "<f4", (3,)), ("corners", "<f4", (3, 3)), ("attributes", "<u2")])


def write_stl(path: Path, document: Document, settings: Settings) -> None:
    """Write one state as triangles: two for each panel, or the closed surfaces of boards.

    The z axis is up. Corners go round as seen from the front (above, in the flat sheet) and
    normals point there. Coordinates are in the document's unit, which the header names (STL has
    no place for it), rounded to single precision: about 6e-8 of the distance from the origin. Far
    from it they are about a point beside the shell, which the header names.
    """
    nearby = document.nearby
    vertices, faces = find_surface(document, settings.state)
    triangles = (vertices + (document.origin - nearby))[faces]
    if document.boards is None:
        triangles = split_panels(triangles)
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    records = np.zeros(len(triangles), _RECORD)
    records["normal"] = normals / np.where(length > 0, length, 1.0) + 0.0
    records["corners"] = triangles
    with path.open("wb") as file:
        file.write(_header(document, nearby))
        file.write(len(records).to_bytes(4, "little"))
        file.write(records.tobytes())


def _header(document: Document, nearby: Array) -> bytes:
    """Eighty bytes that do not begin with "solid", by which readers know text files."""
    about = " about ({:g}, {:g}, {:g})".format(*nearby) if nearby.any() else ""
    words = f"orishell, unit {document.unit}, z up{about}: {' '.join(document.title.split())}"
    return words.encode("ascii", "replace")[:HEADER_LENGTH].ljust(HEADER_LENGTH)


FORMAT = Format("stl", "shell.stl", (".stl",), "one state (STL)", write_stl, task="cad")
