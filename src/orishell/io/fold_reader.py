"""FOLD files (1.0 to 1.2) of quadrilateral panels, with all their frames, by any program."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from orishell.conventions.arguments import path_of
from orishell.conventions.errors import InputError, printable
from orishell.conventions.record import record
from orishell.document import LARGEST
from orishell.io.fold_frames import (
    Frames,
    misfit,
    number_list,
    number_table,
    read_frames,
    read_grid_shape,
    read_title,
    read_unit,
    require_vertices,
    shown,
)
from orishell.io.fold_polygons import find_corners, read_loops
from orishell.motion.mesh import QuadMesh, build_mesh
from orishell.numerics.arrays import Array, Integers

LETTERS = frozenset("BMVFUCJ")
"""Assignments of FOLD 1.2: border, mountain, valley, flat, unassigned, cut, join."""


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
        return _read(path, read_frames(path))
    except InputError as error:
        raise error.located(f"{path}:") from None


def _read(path: Path, frames: Frames) -> FoldFile:
    coordinates = _coordinates(frames)
    vertex_count = len(next(iter(coordinates.values())))
    faces = _faces(frames, coordinates, vertex_count)
    edges = _vertex_numbers(frames, "edges_vertices", "edge", 2, vertex_count)
    assignment = _assignment(frames, edges)
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
                _classes(frames, number),
                positions,
                _fold_angles(frames, number, edges),
                _drive(frames, number),
                str(frames.raw[number].get("frame_title", "")),
            )
            for number, positions in coordinates.items()
        ),
    )


def _coordinates(frames: Frames) -> dict[int, Array]:
    """Positions (V, 3) of every frame that has any; frames that inherit them share an array."""
    key = "vertices_coords"
    arrays = {
        number: _positions(frame[key], frames.place(number, key))
        for number, frame in enumerate(frames.raw)
        if key in frame
    }
    if not arrays:
        raise InputError("this key is missing in every frame", where=key)
    first = next(iter(arrays))
    for number, positions in arrays.items():
        if len(positions) != len(arrays[first]):
            raise InputError(
                "the frames differ in the number of vertices",
                where=frames.place(number, key),
                got=str(len(positions)),
                expected=f"{len(arrays[first])}, as {frames.place(first, key)}",
            )
    owners = enumerate(source.get(key) for source in frames.sources)
    return {number: arrays[owner] for number, owner in owners if owner is not None}


def _positions(value: Any, where: str) -> Array:
    table = number_table(value, where, "vertex", widths=(2, 3)).astype(np.float64)
    fault = ~(np.abs(table) <= LARGEST).all(axis=1)
    if fault.any():
        vertex = int(np.argmax(fault))
        raise InputError(
            "a coordinate is too large",
            where=f"{where}[{vertex}]",
            got=shown(value[vertex]),
            expected=f"numbers up to {LARGEST:g}",
        )
    positions = np.zeros((len(table), 3))
    positions[:, : table.shape[1]] = table
    positions.flags.writeable = False
    return positions


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
    loops = frames.common(key, lambda value, where: read_loops(value, where, vertex_count))
    if loops is None:
        raise InputError("this key is missing in every frame", where=key)
    corners = find_corners(loops, next(iter(coordinates.values())), key)
    # A panel begins with a corner.
    place = (loops == corners[:, :1]).argmax(axis=1)[:, None]
    count = (loops >= 0).sum(axis=1)[:, None]
    turned = np.arange(loops.shape[1])[None]
    turned = np.where(turned < count, (turned + place) % count, turned)
    return corners, np.take_along_axis(loops, turned, axis=1)


def _vertex_numbers(
    frames: Frames, key: str, row: str, width: int, vertex_count: int
) -> Integers | None:
    """The vertices (rows, width) of faces or edges, which are the same in all frames."""

    def read(value: Any, where: str) -> Integers:
        found = number_table(value, where, row, widths=(width,), whole=True)
        require_vertices(found, vertex_count, where)
        return found.astype(np.int64)

    return frames.common(key, read)


def _assignment(frames: Frames, edges: Integers | None) -> tuple[str, ...] | None:
    def read(value: Any, where: str) -> tuple[str, ...]:
        _require_length(value, edges, where)
        for edge, letter in enumerate(value):
            if not isinstance(letter, str) or letter not in LETTERS:
                raise InputError(
                    "this is no assignment of an edge",
                    where=f"{where}[{edge}]",
                    got=shown(letter),
                    expected="one of " + ", ".join(sorted(LETTERS)),
                )
        return tuple(value)

    return frames.common("edges_assignment", read)


def _fold_angles(frames: Frames, number: int, edges: Integers | None) -> Array | None:
    for key in ("edges_foldAngle", "edges_foldAngles"):
        if key in frames.raw[number]:
            value, where = frames.raw[number][key], frames.place(number, key)
            break
    else:
        return None
    _require_length(value, edges, where)
    angles = number_list(value, where, "edge")
    fault = np.abs(angles) > 180 * (1 + 1e-12)
    if fault.any():
        edge = int(np.argmax(fault))
        raise InputError(
            "a fold angle is out of range",
            where=f"{where}[{edge}]",
            got=shown(value[edge]),
            expected="degrees between -180 and 180",
        )
    angles.flags.writeable = False
    return angles


def _drive(frames: Frames, number: int) -> float | None:
    value = frames.raw[number].get("orishell:drive_deg")
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise misfit(value, frames.place(number, "orishell:drive_deg"), "a number")
    return float(value)


def _classes(frames: Frames, number: int) -> tuple[str, ...]:
    value = frames.raw[number].get("frame_classes", [])
    if not isinstance(value, list) or not all(isinstance(name, str) for name in value):
        raise misfit(value, frames.place(number, "frame_classes"), "a list of texts")
    return tuple(value)


def _require_length(value: Any, edges: Integers | None, where: str) -> None:
    if edges is None:
        raise InputError("without edges_vertices this has no meaning", where=where)
    if not isinstance(value, list) or len(value) != len(edges):
        raise InputError(
            "this list does not fit",
            where=where,
            got=f"{len(value)} entries" if isinstance(value, list) else shown(value),
            expected=f"{len(edges)} entries, one for each edge",
        )
