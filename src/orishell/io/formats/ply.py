"""One state of the shell as binary PLY."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from orishell.document import Document
from orishell.io.format import Format, Settings
from orishell.io.solids import mesh_of, solids_in
from orishell.numerics.arrays import Array, Integers


def write_ply(path: Path, document: Document, settings: Settings) -> None:
    """Write the panels of one state as quadrilaterals.

    Where panels have a thickness it is the closed surfaces of their boards, as triangles; those of
    boards that are clipped on at the target come last.

    The z axis is up. Coordinates are in the document's unit, which a comment names (PLY has no
    place for it), in double precision: not a bit is lost. Panels have no properties: some readers
    stumble over them.

    Parameters
    ----------
    settings
        ``state`` says which state.

    Raises
    ------
    InputError
        If there is no such state.
    """
    vertices, polygons = _polygons(document, settings.state)
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


def _polygons(document: Document, state: int | str) -> tuple[Array, Integers]:
    """Vertices (V, 3) and the corners of faces, four of a panel or three of a board."""
    if document.boards is None:
        return document.state(state).positions, document.mesh.faces
    mesh = mesh_of(solids_in(document, state))
    return mesh.vertices, mesh.triangles


FORMAT = Format("ply", "shell.ply", (".ply",), "one state (PLY)", write_ply)
