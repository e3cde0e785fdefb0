"""The frames of a FOLD file: keys and values of each, and what it inherits from another."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.conventions.source_file import read_source_file
from orishell.io.fold_values import misfit, shown

INHERITED = ("vertices_coords", "faces_vertices")
"""What a frame needs and may take from its parent. Edges are the same in all frames. Fold angles
are those of one state, and what a frame is (``frame_classes``) is said of that frame alone: a
folded state that inherits the mesh of a crease pattern is not a crease pattern."""

NON_MANIFOLD = "nonManifold"
"""What frames call themselves in FOLD where more than two panels meet at an edge. They are passed
over, but the key frame: sheets have no such edges."""

MAX_BYTES = 5_000_000_000


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
    return _sheets(Frames(raw, _sources(raw, parents)))


def _sheets(frames: Frames) -> Frames:
    """The frames without those that call themselves non-manifold, and those with their mesh."""
    passed = {
        number
        for number, frame in enumerate(frames.raw)
        if number and NON_MANIFOLD in _attributes(frame)
    }
    passed |= {
        number for number, source in enumerate(frames.sources) if passed & {*source.values()}
    }
    return Frames(
        tuple({} if number in passed else frame for number, frame in enumerate(frames.raw)),
        tuple({} if number in passed else source for number, source in enumerate(frames.sources)),
    )


def _attributes(frame: dict[str, Any]) -> list[Any]:
    found = frame.get("frame_attributes", [])
    return found if isinstance(found, list) else []


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
