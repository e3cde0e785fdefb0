"""The frames of a FOLD file as arrays, or the first entry that does not fit."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.conventions.source_file import read_source_file
from orishell.io.format import plain_line
from orishell.motion.mesh import QuadMesh
from orishell.numerics.arrays import Array, Integers

T = TypeVar("T")


def number_table(
    value: Any, where: str, row: str, *, widths: tuple[int, ...], whole: bool = False
) -> NDArray[Any]:
    """A list of lists of numbers, all of one length, as array (rows, width).

    ``row`` is what one row is ("vertex", "panel"), ``widths`` the lengths that it may have.

    Raises InputError: Naming the first row that does not fit.
    """
    if not isinstance(value, list):
        raise misfit(value, where, "a list")
    if not value:
        raise InputError("this list is empty", where=where)
    try:
        table = np.array(value)
    except (ValueError, OverflowError):
        table = np.array(None)
    kinds = "iu" if whole else "iuf"
    if table.ndim == 2 and table.shape[1] in widths and table.dtype.kind in kinds:
        return table
    raise _first_misfit(value, where, row, widths, whole)


def require_vertices(
    rows: Integers, vertex_count: int, where: str, *, count: Integers | None = None
) -> None:
    """Refuse numbers of vertices (N, K) that are not there; rows have so many (N,), or K each.

    Raises InputError: Naming the first row with one.
    """
    missing = (rows < 0) | (rows >= vertex_count)
    if count is not None:
        missing &= np.arange(rows.shape[1]) < count[:, None]
    if missing.any():
        row = int(missing.any(axis=1).argmax())
        here = rows[row, : None if count is None else count[row]]
        raise InputError(
            "there is no such vertex",
            where=f"{where}[{row}]",
            got=str(here.tolist()),
            expected=f"numbers from 0 to {vertex_count - 1}",
        )


def number_list(value: list[Any], where: str, entry: str) -> Array:
    """A list of numbers as array, NaN where it has null.

    Raises InputError: Naming the first entry that is no number.
    """
    for index, number in enumerate(value):
        if not _is_number(number, whole=False) and number is not None:
            raise misfit(number, f"{where}[{index}]", f"a number for each {entry}")
    return np.array([np.nan if number is None else float(number) for number in value])


def misfit(value: Any, where: str, expected: str) -> InputError:
    """The error for a value of the wrong kind."""
    return InputError("this value does not fit", where=where, got=shown(value), expected=expected)


def shown(value: Any) -> str:
    """A value as messages quote it."""
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


def _first_misfit(
    value: list[Any], where: str, row: str, widths: tuple[int, ...], whole: bool
) -> InputError:
    numbers = "whole numbers" if whole else "numbers"
    accepted = [entry for entry in value if _is_row(entry, widths, whole)]
    if accepted:
        widths = (len(accepted[0]),)
    expected = f"{' or '.join(map(str, widths))} {numbers} for each {row}"
    for index, entry in enumerate(value):
        if not _is_row(entry, widths, whole):
            return InputError(
                f"{row} {index} does not fit",
                where=f"{where}[{index}]",
                got=f"{len(entry)} {numbers}" if _is_row(entry, None, whole) else shown(entry),
                expected=expected,
            )
    return InputError("the numbers are too large", where=where, expected=expected)


def _is_row(entry: Any, widths: tuple[int, ...] | None, whole: bool) -> bool:
    return (
        isinstance(entry, list)
        and (widths is None or len(entry) in widths)
        and all(_is_number(number, whole) for number in entry)
    )


def _is_number(value: Any, whole: bool) -> bool:
    return isinstance(value, int if whole else (int, float)) and not isinstance(value, bool)


INHERITED = ("vertices_coords", "faces_vertices")
"""What a frame needs and may take from its parent. Edges are the same in all frames. Fold angles
are those of one state, and what a frame is (``frame_classes``) is said of that frame alone: a
folded state that inherits the mesh of a crease pattern is not a crease pattern."""

MAX_BYTES = 5_000_000_000


class FramesError(InputError):
    """Frames that are not states of one sheet."""


@record
class Frames:
    """The frames of a file, and which frame each inherited value comes from."""

    raw: tuple[dict[str, Any], ...]  # keys and values that each frame itself has; 0: the key frame
    sources: tuple[dict[str, int], ...]  # the frame that each inheritable key comes from

    def __len__(self) -> int:
        return len(self.raw)

    @property
    def first(self) -> Frames:
        """The key frame alone."""
        return Frames(self.raw[:1], self.sources[:1])

    def common(self, key: str, read: Callable[[Any, str], T]) -> T | None:
        """What is read from the values of a key, the same in all frames; None if none has it.

        ``read`` is given a value and its place, as messages name it.
        """
        known: T | None = None
        for number, frame in enumerate(self.raw):
            if key in frame:
                where = self.place(number, key)
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

    def place(self, number: int, key: str) -> str:
        """A key as messages name it."""
        return f"frame {number} {key}" if len(self) > 1 else key


def read_frames(path: Path) -> Frames:
    """Read a file and find out what its frames inherit.

    Raises InputError if it is no FOLD file, or a frame's parent does not exist or is its own
    descendant.
    """
    content = _read_json(path)
    frames = content.pop("file_frames", [])
    if not isinstance(frames, list) or not all(isinstance(frame, dict) for frame in frames):
        raise misfit(frames, "file_frames", "a list of frames")
    raw = (content, *frames)
    parents = [None, *(_parent(frame, number, len(raw)) for number, frame in enumerate(frames, 1))]
    return Frames(raw, _sources(raw, parents))


def _parent(frame: dict[str, Any], number: int, count: int) -> int | None:
    """The frame that a frame inherits from; None if it does not."""
    inherit, parent = frame.get("frame_inherit", False), frame.get("frame_parent")
    if not isinstance(inherit, bool):
        raise misfit(inherit, f"frame {number} frame_inherit", "true or false")
    if not inherit:
        return None
    if type(parent) is not int or not 0 <= parent < count or parent == number:
        raise InputError(
            "this frame inherits from no other frame",
            where=f"frame {number} frame_parent",
            got="nothing" if parent is None else shown(parent),
            expected=f"the number of another frame, from 0 to {count - 1}",
        )
    return parent


def _sources(
    raw: tuple[dict[str, Any], ...], parents: list[int | None]
) -> tuple[dict[str, int], ...]:
    """Follow every frame's parents to one that is done, then come back."""
    done: dict[int, dict[str, int]] = {}
    for number in range(len(raw)):
        line: dict[int, None] = {}
        at: int | None = number
        while at is not None and at not in done:
            if at in line:
                raise InputError(
                    "the frames inherit from each other in a circle",
                    where=f"frame {at} frame_parent",
                    got=" -> ".join(map(str, [*list(line)[:5], "..."] if len(line) > 5 else line)),
                )
            line[at] = None
            at = parents[at]
        inherited = {} if at is None else done[at]
        for frame in reversed(line):
            own = {key: frame for key in INHERITED if key in raw[frame]}
            inherited = done[frame] = {**inherited, **own}
    return tuple(done[number] for number in range(len(raw)))


def _read_json(path: Path) -> dict[str, Any]:
    import orjson

    try:
        content = orjson.loads(
            read_source_file(path, "file", MAX_BYTES).removeprefix(b"\xef\xbb\xbf")
        )
    except orjson.JSONDecodeError as error:
        raise InputError("this is not JSON", got=str(error)) from None
    if not isinstance(content, dict):
        raise InputError("this is not FOLD", got=shown(content), expected="an object with keys")
    return content


def read_title(frames: Frames) -> str:
    """What the file calls itself, without line breaks; empty if it does not."""
    return plain_line(_text(frames.raw[0].get("file_title", ""), "file_title")[:200])


def read_unit(frames: Frames) -> str:
    """The unit of length of all frames; "unit" if none is named."""
    unit = frames.common("frame_unit", _text)
    return "unit" if unit is None else unit


def _text(value: Any, where: str) -> str:
    if not isinstance(value, str):
        raise misfit(value, where, "a text")
    return value


def read_grid_shape(frames: Frames, mesh: QuadMesh) -> tuple[int, int] | None:
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
