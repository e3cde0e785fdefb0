"""What a FOLD file (1.0 to 1.2) says of its one sheet, whatever its panels are, as arrays."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.document import LARGEST_COORDINATE
from orishell.io.fold_frames import Frames
from orishell.io.fold_polygons import read_polygons
from orishell.io.fold_values import (
    misfit,
    number_list,
    number_table,
    require_text,
    require_vertices,
    shown,
)
from orishell.io.format import plain_line
from orishell.numerics.arrays import Array, Integers

LETTERS = frozenset("BMVFUCJ")
"""Assignments of FOLD 1.2: border, mountain, valley, flat, unassigned, cut, join."""
FACES = "faces_vertices"
T = TypeVar("T")


class FramesError(InputError):
    """Frames that are not states of one sheet."""


@record
class FoldFrame:
    """One state of the sheet."""

    number: int  # the frame's number in the file: 0 is the key frame
    classes: tuple[str, ...]  # its own ``frame_classes``
    positions: Array  # vertices (V, 3), read-only; z is 0 where the file gives two coordinates
    # Fold angles (E,) that the frame itself gives, NaN where it gives none; None if it has no such
    # list or inherits it. In degrees, as in the file: not a bit is lost.
    fold_angles_deg: Array | None
    drive_deg: float | None = None  # drive angle, where the frame says it
    title: str = ""  # its ``frame_title``; empty if it has none

    @property
    def fold_angles(self) -> Array | None:
        """Fold angles (E,) that the frame itself gives (radians)."""
        return None if self.fold_angles_deg is None else np.deg2rad(self.fold_angles_deg)


@record
class FoldContent:
    """A FOLD file as it was read: panels, edges and states of a sheet."""

    title: str  # what the file calls itself, without line breaks; empty if it does not
    unit: str  # unit of length; "unit" if the file names none
    faces: Integers | None  # vertices (F, K) around every panel, -1 behind the last; None: no list
    edges: Integers | None  # vertices (E, 2) of every edge
    assignment: tuple[str, ...] | None  # letter (E,) of every edge
    frames: tuple[FoldFrame, ...]  # the frames that have coordinates, in the order of the file

    @property
    def vertex_count(self) -> int:
        """Number of vertices, the same in all frames."""
        return len(self.frames[0].positions)


def read_content(frames: Frames) -> FoldContent:
    """The arrays of a file.

    Raises InputError: Naming the frame, the key, what was found and what is expected; FramesError
    if its frames are of several sheets.
    """
    coordinates = _coordinates(frames)
    count = len(next(iter(coordinates.values())))

    def edges_of(value: Any, where: str) -> Integers:
        found = number_table(value, where, "edge", widths=(2,), whole=True)
        require_vertices(found, count, where)
        return found.astype(np.int64)

    faces = _common(frames, FACES, lambda value, where: read_polygons(value, where, count))
    edges = _common(frames, "edges_vertices", edges_of)
    return FoldContent(
        title=plain_line(require_text(frames.raw[0].get("file_title", ""), "file_title")[:200]),
        unit=_common(frames, "frame_unit", require_text) or "unit",
        faces=faces,
        edges=edges,
        assignment=_assignment(frames, edges),
        frames=tuple(
            FoldFrame(
                number,
                _classes(frames, number),
                positions,
                _fold_angles(frames, number, edges),
                title=str(frames.raw[number].get("frame_title", "")),
            )
            for number, positions in coordinates.items()
        ),
    )


def _common(frames: Frames, key: str, read: Callable[[Any, str], T]) -> T | None:
    """What is read from the values of a key, the same in all frames; None if none has it.

    ``read`` is given a value and its place, as messages name it.
    """
    known: T | None = None
    for number, frame in enumerate(frames.raw):
        if key in frame:
            where = frames.place(number, key)
            found = read(frame[key], where)
            if known is not None and not np.array_equal(np.asarray(known), np.asarray(found)):
                raise FramesError(
                    "the frames differ in more than their coordinates and fold angles",
                    where=where,
                    expected="the same list in every frame that has one",
                    remedy="write each model to a file of its own",
                )
            known = found
    return known


def _coordinates(frames: Frames) -> dict[int, Array]:
    """Positions (V, 3) of every frame that has any; frames that inherit them share an array.

    Raises InputError: If no frame has any, or they differ in number.
    """
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
            raise FramesError(
                "the frames differ in the number of vertices",
                where=frames.place(number, key),
                got=str(len(positions)),
                expected=f"{len(arrays[first])}, as {frames.place(first, key)}",
                remedy="write each model to a file of its own",
            )
    owners = enumerate(source.get(key) for source in frames.sources)
    return {number: arrays[owner] for number, owner in owners if owner is not None}


def _positions(value: Any, where: str) -> Array:
    table = number_table(value, where, "vertex", widths=(2, 3)).astype(np.float64)
    fault = ~(np.abs(table) <= LARGEST_COORDINATE).all(axis=1)
    if fault.any():
        vertex = int(np.argmax(fault))
        raise InputError(
            "a coordinate is too large",
            where=f"{where}[{vertex}]",
            got=shown(value[vertex]),
            expected=f"numbers up to {LARGEST_COORDINATE:g}",
        )
    positions = np.zeros((len(table), 3))
    positions[:, : table.shape[1]] = table
    positions.flags.writeable = False
    return positions


def _assignment(frames: Frames, edges: Integers | None) -> tuple[str, ...] | None:
    """Letter (E,) of every edge; None if no frame has any.

    Raises InputError: Naming the first that is none.
    """

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

    return _common(frames, "edges_assignment", read)


def _fold_angles(frames: Frames, number: int, edges: Integers | None) -> Array | None:
    """Fold angles (E,) that a frame itself gives, NaN where it gives none (degrees); or None.

    Raises InputError: Naming the first that is none, or is out of range.
    """
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


def _classes(frames: Frames, number: int) -> tuple[str, ...]:
    """What a frame says that it is.

    Raises InputError: If that is no list of texts.
    """
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
