"""What a FOLD file says of itself: title, unit, grid."""

from __future__ import annotations

import numpy as np

from orishell.io.fold_frames import Frames, differing
from orishell.io.json_arrays import misfit
from orishell.motion.mesh import QuadMesh


def read_title(frames: Frames) -> str:
    """What the file calls itself, without line breaks; empty if it does not."""
    title = frames.own(0).get("file_title", "")
    if not isinstance(title, str):
        raise misfit(title, "file_title", "a text")
    return "".join(each if each.isprintable() else " " for each in title[:200])


def read_unit(frames: Frames) -> str:
    """The unit of length of all frames; "unit" if none is named."""
    unit = None
    for owner in frames.owners("frame_unit"):
        value, where = frames.value(owner, "frame_unit"), frames.place(owner, "frame_unit")
        if not isinstance(value, str):
            raise misfit(value, where, "a text")
        if unit is not None and value != unit:
            raise differing(where)
        unit = value
    return "unit" if unit is None else unit


def read_grid_shape(frames: Frames, mesh: QuadMesh) -> tuple[int, int] | None:
    """Rows and columns of vertices that the file states, if its panels do form that grid."""
    for owner in frames.owners("orishell:grid_shape"):
        match frames.value(owner, "orishell:grid_shape"):
            case [int(rows), int(columns)] if rows * columns == mesh.vertex_count and columns > 1:
                corners = np.sort(mesh.faces, axis=1)
                first = corners[:, :1]
                fits = corners == first + np.array([0, 1, columns, columns + 1])
                if fits.all() and (first % columns != columns - 1).all():
                    return rows, columns
    return None
