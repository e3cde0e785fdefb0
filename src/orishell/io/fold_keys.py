"""Keys of a FOLD file that mean the same whatever its panels are."""

from __future__ import annotations

from typing import Any

import numpy as np

from orishell.conventions.errors import InputError
from orishell.document import LARGEST_COORDINATE
from orishell.io.fold_frames import (
    Frames,
    FramesError,
    misfit,
    number_list,
    number_table,
    require_vertices,
    shown,
)
from orishell.numerics.arrays import Array, Integers

LETTERS = frozenset("BMVFUCJ")
"""Assignments of FOLD 1.2: border, mountain, valley, flat, unassigned, cut, join."""


def read_coordinates(frames: Frames) -> dict[int, Array]:
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


def read_vertex_numbers(
    frames: Frames, key: str, row: str, width: int, vertex_count: int
) -> Integers | None:
    """The vertices (rows, width) of faces or edges, which are the same in all frames.

    Raises InputError: Naming the first row that does not fit.
    """

    def read(value: Any, where: str) -> Integers:
        found = number_table(value, where, row, widths=(width,), whole=True)
        require_vertices(found, vertex_count, where)
        return found.astype(np.int64)

    return frames.common(key, read)


def read_assignment(frames: Frames, edges: Integers | None) -> tuple[str, ...] | None:
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

    return frames.common("edges_assignment", read)


def read_fold_angles(frames: Frames, number: int, edges: Integers | None) -> Array | None:
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


def read_classes(frames: Frames, number: int) -> tuple[str, ...]:
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
