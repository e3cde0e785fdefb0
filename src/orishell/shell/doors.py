"""Doors in end walls: what has no room for one, and what would have.

A shell twice as large has a wall twice as large: how large a shell of the same form must be for a
door is known from its border, and no such shell needs to be made.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import rounded_down
from orishell.conventions.quantities import plain
from orishell.design.end_walls import Door, EndWall
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import bisect
from orishell.solids.end_walls import room_for_door
from orishell.workshop.fitting import above

LINTEL = 0.02
"""What is left over a door at least, as a share of the door's height."""
NARROWER = (0.9, 0.75, 0.6, 0.5)
"""Shares of a door's width that are offered."""
LARGEST = 100.0
"""So many times as large a shell is looked at, at most."""
DIGITS = 1e-3
"""To this share it is told how much larger a shell must be."""


def require_room_for_door(border: Array, wall: EndWall, key: str, highest: float) -> None:
    """Refuse a door that the wall below a border (N, 2) has no room for.

    key: Where the design file has the wall.
    highest: The height of the whole shell over the ground (length).
    Raises DesignError: with how large the wall, the shell, and a shell that has room for it are.
    """
    door = wall.door
    if door is None or _has_room(border, door):
        return
    room = room_for_door(border, door)
    raise DesignError(
        "an end wall has no room for its door",
        place=f"at the {wall.at} end",
        keys=tuple(f"{key}.door.{each}" for each in ("width", "height", "offset")),
        size=_sizes(border, door, room, highest),
        candidates=[*_smaller(border, door, key, room), Remedy({f"{key}.door": None})],
        excess=None if not room else (1 + LINTEL) * door.height / room - 1,
    )


def _sizes(border: Array, door: Door, room: float, highest: float) -> str:
    """How high the wall is over the door, and the shell at most, and how large it must be."""
    said = f"the wall is {plain(room, 3)} high there, and the door {plain(door.height, 3)}"
    if not room:
        said = f"the door goes past the wall, which is {plain(float(np.ptp(border[:, 0])), 3)} wide"
    if highest < (1 + LINTEL) * door.height:
        said += f"; the whole shell is {plain(highest, 3)} high, so no wall of it has room for one"
    factor = _larger(border, door)
    if factor is None:
        return said
    return f"{said}; a shell of this form has room for it at {plain(factor)} times its size"


def _larger(border: Array, door: Door) -> float | None:
    """How many times as large a border (N, 2) has room for a door, rounded up; None if none has."""
    most = 1.0
    while not _has_room(most * border, door):
        most *= 2
        if most > LARGEST:
            return None
    found = bisect(lambda each: _has_room(each * border, door), most, 0.5 * most, relative=DIGITS)
    return above(found)


def _smaller(border: Array, door: Door, key: str, room: float) -> Iterator[Remedy]:
    """Doors that a wall has room for: lower, in its middle, or narrower."""
    if room > 0:
        yield Remedy({f"{key}.door.height": rounded_down(room / (1 + LINTEL))})
    if door.offset:
        yield Remedy({f"{key}.door.offset": 0.0})
    for width in (rounded_down(door.width * share) for share in NARROWER):
        if _has_room(border, door.replace_unchecked(width=width)):
            yield Remedy({f"{key}.door.width": width})
            return


def _has_room(border: Array, door: Door) -> bool:
    return room_for_door(border, door) >= (1 + LINTEL) * door.height
