"""One state of the shell as binary PLY."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from orishell.document import Document
from orishell.io.format import Format, Settings
from orishell.io.solids import find_surface


def write_ply(path: Path, document: Document, settings: Settings) -> None:
    """Write one state: panels as quadrilaterals, or the closed surfaces of boards as triangles.

    The z axis is up. Coordinates are in the document's unit, which a comment names (PLY has no
    place for it), in double precision: not a bit is lost. Panels have no properties: some readers
    stumble over them.
    """
    vertices, polygons = find_surface(document, settings.state)
    positions, corners = document.in_world(vertices), polygons.shape[1]
    kind = np.dtype([("corner_count", "u1"), ("vertex_indices", "<i4", (corners,))])
    faces = np.empty(len(polygons), kind)
    faces["corner_count"], faces["vertex_indices"] = corners, polygons
    lines = [
        "ply",
        "format binary_little_endian 1.0",
        f"comment {' '.join(document.title.split())}",
        f"comment Unit: {document.unit}. Up: z.",
        f"element vertex {len(positions)}",
        *(f"property double {axis}" for axis in "xyz"),
        f"element face {len(faces)}",
        "property list uchar int vertex_indices",
        "end_header",
    ]
    with path.open("wb") as file:
        file.write("".join(f"{line}\n" for line in lines).encode("ascii", "replace"))
        file.write(positions.astype("<f8").tobytes())
        file.write(faces.tobytes())


FORMAT = Format("ply", "shell.ply", (".ply",), "one state (PLY)", write_ply, task="cad")
