"""FOLD 1.2: files that are written, and documents of files that were read."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from orishell.conventions.arguments import path_of
from orishell.conventions.quantities import MILLIMETRES
from orishell.conventions.version import __version__
from orishell.document import SHELL, Document, DocumentState
from orishell.io.fold_content import FoldFrame
from orishell.io.fold_frames import NON_MANIFOLD
from orishell.io.fold_girders import HungSheet, hangs, hung_sheet
from orishell.io.fold_reader import FoldFile
from orishell.io.format import DEFAULT_SETTINGS, Settings
from orishell.io.output import OutputDirectory
from orishell.motion.mesh import measure_mesh_folds
from orishell.numerics.arrays import Array


def document_of_fold(file: FoldFile, unit: str | None = None) -> Document:
    """The document of a FOLD file by any program.

    The flat sheet is the first frame that calls itself a crease pattern, or else the first that
    lies in z = 0; all frames that do not are the states, in the order of the file.

    Parameters
    ----------
    unit
        Unit of length to be stated instead of the file's own.
    """
    level = [frame for frame in file.frames if not frame.positions[:, 2].any()]
    named = [frame for frame in level if "creasePattern" in frame.classes]
    flat = next(iter(named or level), None)
    folded = [
        frame for frame in file.frames if frame is not flat and "creasePattern" not in frame.classes
    ]
    states = tuple(
        DocumentState(frame.positions, frame.fold_angles_deg, frame.drive_deg) for frame in folded
    )
    titles = {frame.title: number for number, frame in enumerate(folded)}
    known = file.unit if file.unit in MILLIMETRES else "unit"
    plane = None
    if flat is not None:
        plane = np.ascontiguousarray(flat.positions[:, :2])
        plane.flags.writeable = False
    return Document(
        title=file.title,
        unit=unit or known,
        mesh=file.mesh,
        assignment=file.assignment or tuple("U" if fold else "B" for fold in file.mesh.crease),
        flat=plane,
        fold_angles_deg=_fold_angles(file, flat, states[titles.get(SHELL, -1)] if states else None),
        states=states,
        grid_shape=file.grid_shape,
        curves={},
        named={name: titles[name] for name in ("flat", SHELL, "pack", "open") if name in titles},
    )


def _fold_angles(file: FoldFile, flat: FoldFrame | None, shell: DocumentState | None) -> Array:
    """Fold angles (E,): those the flat sheet gives, else the shell's, given or measured."""
    if flat is not None and flat.fold_angles_deg is not None:
        return flat.fold_angles_deg
    if shell is None:
        return np.full(len(file.mesh.edges), np.nan)
    if shell.fold_angles_deg is not None:
        return shell.fold_angles_deg
    return np.rad2deg(measure_mesh_folds(file.mesh, shell.positions))


def write_fold(
    path: str | Path,
    document: Document,
    settings: Settings = DEFAULT_SETTINGS,
    *,
    force: bool = False,
) -> None:
    """Write a FOLD file (the contract's page says what is in it).

    Coordinates and angles have all their digits: :func:`orishell.io.read_fold` gives back the
    same numbers to the last bit. States are taken one by one, so that only one need be in memory.
    Parts that are there in all frames are panels as well, which do not hang together with it.
    Box girders, and a second skin, are in further frames, which call themselves "nonManifold": more
    than two panels meet at edges there. They are passed over when the file is read.
    Without a flat sheet the first state is the key frame.

    Parameters
    ----------
    path
        The file to write.
    force
        Whether a file there that orishell did not write, or that was changed, may be written over.

    Raises
    ------
    InputError
        If the file cannot be written, or another is in its way.
    """
    path = path_of(path, "write_fold: path")
    with OutputDirectory(path.parent, force=force).adding() as draft:
        dump_fold(draft / path.name, document, settings)


def dump_fold(path: Path, document: Document, _: Settings) -> None:
    """Write a FOLD file where nothing else is."""
    import orjson

    def dump(value: Any) -> bytes:
        return orjson.dumps(value, option=orjson.OPT_SERIALIZE_NUMPY)

    # Frames have the panels of the first, what is not there in all of them left out; more follow.
    hung = hung_sheet(document)
    moving = document.moving[1:]
    parts = [part for part in moving if not (part.joined_from_deg or hangs(part))]
    document = document.with_moving(parts)
    names = {number: name for name, number in document.named.items()}
    titles = names if "pack" in document.named else {}
    states = (
        {**_state(document, state), **({"frame_title": titles[k]} if k in titles else {})}
        for k, state in enumerate(document.states)
    )
    key = _flat(document) if document.flat is not None else next(states)
    with path.open("wb") as file:
        file.write(dump({**_head(document), **key, **_mesh(document)})[:-1])
        separator = b',\n"file_frames":[\n'
        for state in states:
            frame = {**state, "frame_parent": 0, "frame_inherit": True}
            file.write(separator + dump(frame))
            separator = b",\n"
        for frame in () if hung is None else _frames_of(hung):
            file.write(separator + dump(frame))
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


def _frames_of(hung: HungSheet) -> Iterator[dict[str, Any]]:
    """Frames of the sheet with what hangs on it, for every state in which that is there."""
    states = hung.document.states
    before = len(states) + (hung.document.flat is not None)
    there = [number for number in range(len(states)) if hung.is_there(number)]
    names = {number: name for name, number in hung.document.named.items()}
    for number in there:
        same = {"frame_parent": before, "frame_inherit": True}
        drive = states[number].drive_deg
        yield {
            "frame_classes": ["foldedForm"],
            "frame_attributes": ["3D", NON_MANIFOLD],
            **({"frame_title": f"{names[number]}, with {hung.called}"} if number in names else {}),
            **(hung.mesh() if number == there[0] else same),
            **hung.state(number),
            **({"orishell:drive_deg": drive} if drive is not None else {}),
        }


def _angles(degrees: Array | None) -> dict[str, Any]:
    """Fold angles; what is not known is null in FOLD, as orjson writes NaN."""
    if degrees is None or np.isnan(degrees).all():
        return {}
    return {"edges_foldAngle": degrees}


def _mesh(document: Document) -> dict[str, Any]:
    shape, mesh = document.whole_grid, document.mesh
    return {
        "edges_vertices": mesh.edges,
        "edges_assignment": document.assignment,
        "faces_vertices": mesh.around(),
        "faces_edges": mesh.around_edges(),
        **({"orishell:grid_shape": list(shape)} if shape is not None else {}),
    }
