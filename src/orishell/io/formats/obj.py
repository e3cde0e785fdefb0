"""One state of the shell as Wavefront OBJ."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from orishell.document import Document
from orishell.io.format import Format
from orishell.io.settings import Settings
from orishell.numerics.arrays import Array, Integers


def write_obj(path: Path, document: Document, settings: Settings) -> None:
    """Write the panels of one state as quadrilaterals.

    The y axis is up, as readers of OBJ expect: a point (x, y, z) is written as (x, z, -y).
    Coordinates are in the document's unit, which a comment names (OBJ has no place for it), and
    have all their digits. A grid has one group for each row of panels, any other sheet one group.
    At the target each board that is clipped on there is a group of its own, after the sheet.
    Without smoothing (``s off``) creases stay sharp.

    Parameters
    ----------
    settings
        ``state`` says which state.

    Raises
    ------
    InputError
        If there is no such state.
    """
    state = document.state(settings.state)
    with path.open("w", encoding="utf-8", newline="\n") as file:
        file.write(f"# {' '.join(document.title.split())}\n# Unit: {document.unit}. Up: y.\n")
        file.writelines(_vertices(document.in_world(state.positions)))
        file.write("s off\n")
        file.writelines(_panels(document))
        first = 1 + len(state.positions)
        for number, board in enumerate(document.clipped_at(settings.state), 1):
            file.writelines(_vertices(document.in_world(board.shell.positions)))
            file.write(f"g board_{number}\n")
            file.writelines(_faces(board.mesh.faces + first))
            first += board.mesh.vertex_count


def _vertices(positions: Array) -> Iterator[str]:
    return (f"v {x!r} {y!r} {z!r}\n" for x, y, z in _y_up(positions).tolist())


def _panels(document: Document) -> Iterator[str]:
    faces = document.mesh.faces
    row = len(faces) if document.grid_shape is None else document.grid_shape[1] - 1
    for number, begin in enumerate(range(0, len(faces), row)):
        yield "g panels\n" if document.grid_shape is None else f"g row_{number}\n"
        yield from _faces(faces[begin : begin + row] + 1)


def _faces(faces: Integers) -> Iterator[str]:
    return (f"f {a} {b} {c} {d}\n" for a, b, c, d in faces.tolist())


def _y_up(positions: Array) -> Array:
    """Points (V, 3) turned about the x axis so that z comes to lie on y; without -0.0."""
    return np.asarray(positions[:, [0, 2, 1]] * [1.0, 1.0, -1.0] + 0.0)


FORMAT = Format("obj", "shell.obj", (".obj",), "one state (Wavefront OBJ)", write_obj)
