"""Panels in space in an OBJ file, as programs that fold save a state: its one frame."""

from __future__ import annotations

from pathlib import Path

from orishell.conventions.errors import InputError
from orishell.conventions.source_file import read_source_file
from orishell.design.mesh_errors import MeshFileError
from orishell.design.mesh_text import plain_obj
from orishell.io.fold_frames import MAX_BYTES, Frames


def read_obj_frames(path: Path) -> Frames:
    """Vertices and panels of a file, as keys of FOLD.

    Raises InputError: If a line does not fit, or there are no panels.
    """
    try:
        text = plain_obj(read_source_file(path, "file", MAX_BYTES))[0].decode()
    except MeshFileError as error:
        raise InputError(
            "the file is not OBJ", where=error.where, got=error.got, expected=error.expected
        ) from None
    vertices, faces = [], []
    for line in text.splitlines():
        kind, *words = line.split()
        if kind == "v":
            vertices.append([float(word) for word in words])
        else:
            faces.append([int(word) - 1 for word in words])
    if not faces:
        raise InputError(
            "the file has no panels",
            expected="vertices (v) and panels (f)",
            remedy="save the sheet with its faces, or as FOLD",
        )
    keys = {"vertices_coords": vertices, "faces_vertices": faces}
    return Frames((keys,), (dict.fromkeys(keys, 0),))
