"""The document of a FOLD file, from which other formats are written."""

from __future__ import annotations

import numpy as np

from orishell.conventions.units import MILLIMETRES
from orishell.document import SHELL, Document, DocumentState
from orishell.io.fold_reader import FoldFile, FoldFrame
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
    flat = _find_flat(file.frames)
    folded = [
        frame for frame in file.frames if frame is not flat and "creasePattern" not in frame.classes
    ]
    states = tuple(
        DocumentState(frame.positions, frame.fold_angles_deg, frame.drive_deg) for frame in folded
    )
    titles = {frame.title: number for number, frame in enumerate(folded)}
    known = file.unit if file.unit in MILLIMETRES else "unit"
    return Document(
        title=file.title,
        unit=unit or known,
        mesh=file.mesh,
        assignment=file.assignment or _guess(file),
        flat=None if flat is None else _in_plane(flat.positions),
        fold_angles_deg=_fold_angles(file, flat, states[titles.get(SHELL, -1)] if states else None),
        states=states,
        grid_shape=file.grid_shape,
        curves={},
        named={name: titles[name] for name in ("flat", SHELL, "pack") if name in titles},
    )


def _find_flat(frames: tuple[FoldFrame, ...]) -> FoldFrame | None:
    level = [frame for frame in frames if not frame.positions[:, 2].any()]
    named = [frame for frame in level if "creasePattern" in frame.classes]
    return next(iter(named or level), None)


def _in_plane(positions: Array) -> Array:
    flat = np.ascontiguousarray(positions[:, :2])
    flat.flags.writeable = False
    return flat


def _fold_angles(file: FoldFile, flat: FoldFrame | None, shell: DocumentState | None) -> Array:
    """Fold angles (E,): those the flat sheet gives, else the shell's, given or measured."""
    if flat is not None and flat.fold_angles_deg is not None:
        return flat.fold_angles_deg
    if shell is None:
        return np.full(len(file.mesh.edges), np.nan)
    if shell.fold_angles_deg is not None:
        return shell.fold_angles_deg
    return np.rad2deg(measure_mesh_folds(file.mesh, shell.positions))


def _guess(file: FoldFile) -> tuple[str, ...]:
    """The assignment of a file that gives none: borders B, creases unassigned (U)."""
    return tuple("U" if crease else "B" for crease in file.mesh.crease.tolist())
