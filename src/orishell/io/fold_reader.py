"""FOLD files (1.0 to 1.2) of quadrilateral panels, with all their frames, by any program."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from orishell.conventions.arguments import path_of
from orishell.conventions.errors import InputError, printable
from orishell.conventions.record import record
from orishell.io.fold_frames import (
    Frames,
    misfit,
    read_frames,
    read_grid_shape,
    read_title,
    read_unit,
)
from orishell.io.fold_keys import (
    read_assignment,
    read_classes,
    read_coordinates,
    read_fold_angles,
    read_vertex_numbers,
)
from orishell.io.fold_polygons import find_corners, read_polygons
from orishell.motion.mesh import QuadMesh, build_mesh
from orishell.numerics.arrays import Array, Integers


@record
class FoldFrame:
    """One state of the sheet."""

    number: int  # the frame's number in the file: 0 is the key frame
    classes: tuple[str, ...]  # its own ``frame_classes``
    positions: Array  # vertices (V, 3), read-only; z is 0 where the file gives two coordinates
    # Fold angles (E,) that the frame itself gives, NaN where it gives none; None if it has no such
    # list or inherits it. In degrees, as in the file: not a bit is lost.
    fold_angles_deg: Array | None
    drive_deg: float | None  # drive angle, where the frame says it
    title: str = ""  # its ``frame_title``; empty if it has none

    @property
    def fold_angles(self) -> Array | None:
        """Fold angles (E,) that the frame itself gives (radians)."""
        return None if self.fold_angles_deg is None else np.deg2rad(self.fold_angles_deg)


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
    coordinates = read_coordinates(frames)
    vertex_count = len(next(iter(coordinates.values())))
    faces = _faces(frames, coordinates, vertex_count)
    edges = read_vertex_numbers(frames, "edges_vertices", "edge", 2, vertex_count)
    assignment = read_assignment(frames, edges)
    cut = None if assignment is None else np.array([letter == "C" for letter in assignment])
    mesh = build_mesh(faces[0], vertex_count, edges, cut, faces[1])
    return FoldFile(
        path,
        read_title(frames) or printable(path.stem),
        read_unit(frames),
        mesh,
        assignment,
        read_grid_shape(frames, mesh),
        tuple(
            FoldFrame(
                number,
                read_classes(frames, number),
                positions,
                read_fold_angles(frames, number, edges),
                _drive(frames, number),
                str(frames.raw[number].get("frame_title", "")),
            )
            for number, positions in coordinates.items()
        ),
    )


def _faces(
    frames: Frames, coordinates: dict[int, Array], vertex_count: int
) -> tuple[Integers, Integers]:
    """Corners (F, 4) of all panels, and all vertices (F, K) around them, -1 behind the last."""
    for number in coordinates:
        if "faces_vertices" not in frames.sources[number]:
            raise InputError(
                "this key is missing",
                where=frames.place(number, "faces_vertices"),
                remedy="add faces_vertices"
                + (", or frame_parent and frame_inherit: true" if number else ""),
            )
    key = "faces_vertices"
    loops = frames.common(key, lambda value, where: read_polygons(value, where, vertex_count))
    if loops is None:
        raise InputError("this key is missing in every frame", where=key)
    corners = find_corners(loops, next(iter(coordinates.values())), key)
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
