"""FOLD 1.2: the flat crease pattern as key frame, the motion as further frames."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from orishell.conventions.arguments import path_of
from orishell.conventions.version import __version__
from orishell.document import Document, DocumentState
from orishell.io.format import Format
from orishell.io.settings import DEFAULT_SETTINGS, Settings
from orishell.numerics.arrays import Array


def write_fold(path: str | Path, document: Document, settings: Settings = DEFAULT_SETTINGS) -> None:
    """Write a FOLD file (the contract's page says what is in it).

    Coordinates and angles have all their digits: :func:`orishell.io.read_fold` gives back the
    same numbers to the last bit.

    Parameters
    ----------
    path
        The file to write.
    document
        What is written. States are taken one by one, so that only one need be in memory. Without
        a flat sheet the first state is the key frame.
    """
    import orjson

    def dump(value: Any) -> bytes:
        return orjson.dumps(value, option=orjson.OPT_SERIALIZE_NUMPY)

    names = {number: name for name, number in document.named.items()}
    titles = names if "pack" in document.named else {}
    states = iter(document.states)
    key = _flat(document) if document.flat is not None else _state(document, next(states))
    with path_of(path, "write_fold: path").open("wb") as file:
        file.write(dump({**_head(document), **key, **_mesh(document)})[:-1])
        separator = b',\n"file_frames":[\n'
        for number, state in enumerate(states):
            frame = {**_state(document, state), "frame_parent": 0, "frame_inherit": True}
            if number in titles:
                frame["frame_title"] = titles[number]
            file.write(separator + dump(frame))
            separator = b",\n"
        file.write(b"}\n" if separator.startswith(b',\n"') else b"\n]}\n")


def _head(document: Document) -> dict[str, Any]:
    animated = len(document.states) > 1
    return {
        "file_spec": 1.2,
        "file_creator": f"orishell {__version__}",
        "file_title": document.title,
        "file_classes": ["singleModel", "animation"] if animated else ["singleModel"],
        **({"frame_unit": document.unit} if document.unit != "unit" else {}),
    }


def _flat(document: Document) -> dict[str, Any]:
    return {
        "frame_classes": ["creasePattern"],
        "frame_attributes": ["2D"],
        "vertices_coords": document.flat,
        **_angles(document.fold_angles_deg),
    }


def _state(document: Document, state: DocumentState) -> dict[str, Any]:
    drive = state.drive_deg
    return {
        "frame_classes": ["foldedForm"],
        "frame_attributes": ["3D"],
        "vertices_coords": document.in_world(state.positions),
        **_angles(state.fold_angles_deg),
        **({"orishell:drive_deg": drive} if drive is not None else {}),
    }


def _angles(degrees: Array | None) -> dict[str, Any]:
    """Fold angles; what is not known is null in FOLD, as orjson writes NaN."""
    if degrees is None or np.isnan(degrees).all():
        return {}
    return {"edges_foldAngle": degrees}


def _mesh(document: Document) -> dict[str, Any]:
    shape, mesh = document.grid_shape, document.mesh
    return {
        "edges_vertices": mesh.edges,
        "edges_assignment": document.assignment,
        "faces_vertices": mesh.faces,
        "faces_edges": mesh.faces_edges(),
        **({"orishell:grid_shape": list(shape)} if shape is not None else {}),
    }


FORMAT = Format("fold", "shell.fold", (".fold",), "pattern and motion (FOLD 1.2)", write_fold)
