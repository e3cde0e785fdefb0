"""FOLD files (1.0 to 1.2) of quadrilateral panels, with all their frames, by any program."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from orishell.conventions.arguments import path_of
from orishell.conventions.errors import InputError, printable
from orishell.conventions.record import record
from orishell.io.fold_content import FACES, FoldContent, FoldFrame, read_content
from orishell.io.fold_frames import Frames, read_frames
from orishell.io.fold_polygons import find_corners
from orishell.io.fold_values import misfit
from orishell.motion.mesh import QuadMesh, build_mesh
from orishell.numerics.arrays import Integers


@record
class FoldFile:
    """A FOLD file: one mesh and its states."""

    path: Path  # where it was read from
    title: str  # what the file calls itself; its name if it does not
    unit: str  # unit of length; "unit" if the file names none
    mesh: QuadMesh  # panels and edges
    assignment: tuple[str, ...] | None  # letter of every edge; None if the file assigns none
    # rows and columns of vertices where the panels are those of a grid, row by row
    grid_shape: tuple[int, int] | None
    frames: tuple[FoldFrame, ...]  # the frames that have coordinates, in the order of the file


def read_fold(path: str | Path) -> FoldFile:
    """Read and check a FOLD file whose faces have four corners.

    Parameters
    ----------
    path
        The file.

    Raises
    ------
    InputError
        Naming the file, the frame, the key, what was found and what is expected.
    """
    path = path_of(path, "read_fold: path")
    try:
        return fold_of_frames(path, read_frames(path))
    except InputError as error:
        raise error.located(f"{path}:") from None


def fold_of_frames(path: Path, frames: Frames) -> FoldFile:
    """Check what was read from a FOLD file whose faces have four corners.

    Raises InputError: As :func:`read_fold`, without the file's name.
    """
    content = read_content(frames)
    corners, loops = _faces(frames, content)
    assignment = content.assignment
    cut = None if assignment is None else np.array([letter == "C" for letter in assignment])
    mesh = build_mesh(corners, content.vertex_count, content.edges, cut, loops)
    return FoldFile(
        path=path,
        title=content.title or printable(path.stem),
        unit=content.unit,
        mesh=mesh,
        assignment=assignment,
        grid_shape=_grid_shape(frames, mesh),
        frames=tuple(
            replace(each, drive_deg=_drive(frames, each.number)) for each in content.frames
        ),
    )


def _faces(frames: Frames, content: FoldContent) -> tuple[Integers, Integers]:
    """Corners (F, 4) of all panels, and all vertices (F, K) around them, -1 behind the last."""
    for number in (each.number for each in content.frames):
        if FACES not in frames.sources[number]:
            raise InputError(
                "this key is missing",
                where=frames.place(number, FACES),
                remedy=f"add {FACES}"
                + (", or frame_parent and frame_inherit: true" if number else ""),
            )
    loops = content.faces
    if loops is None:
        raise InputError("this key is missing in every frame", where=FACES)
    corners = find_corners(loops, content.frames[0].positions, FACES)
    # A panel begins with a corner.
    place = (loops == corners[:, :1]).argmax(axis=1)[:, None]
    count = (loops >= 0).sum(axis=1)[:, None]
    turned = np.arange(loops.shape[1])[None]
    turned = np.where(turned < count, (turned + place) % count, turned)
    return corners, np.take_along_axis(loops, turned, axis=1)


def _drive(frames: Frames, number: int) -> float | None:
    value = frames.raw[number].get("orishell:drive_deg")
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise misfit(value, frames.place(number, "orishell:drive_deg"), "a number")
    return float(value)


def _grid_shape(frames: Frames, mesh: QuadMesh) -> tuple[int, int] | None:
    """Rows and columns of vertices that the file states, if its panels do form that grid."""
    for frame in frames.raw:
        match frame.get("orishell:grid_shape"):
            case [int(rows), int(columns)] if rows * columns == mesh.vertex_count and columns > 1:
                corners = np.sort(mesh.faces, axis=1)
                first = corners[:, :1]
                fits = corners == first + np.array([0, 1, columns, columns + 1])
                if fits.all() and (first % columns != columns - 1).all():
                    return rows, columns
    return None
