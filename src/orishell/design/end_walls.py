"""The table [[end_wall]]: flat walls that close the ends of a shell, and what is known of them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.conventions.table import Number, Size, Table
from orishell.numerics.arrays import Array, Integers

End = Literal["first", "last"]
"""Which end a wall closes: that along the first column of vertices, or along the last."""
Length = Annotated[Size, Field(gt=0)]


class Door(Table):
    """An opening in an end wall, from the ground up (lengths).

    ``offset`` is how far its middle is from that of the wall, to the right as seen from outside.
    """

    SAMPLE: ClassVar = {"width": 0.9, "height": 2}

    width: Length
    height: Length
    offset: Number = 0.0


class EndWall(Table):
    """A flat, upright wall of strips that closes an end of the shell once that stands.

    It stands on the ground, in the vertical plane that is nearest to the border of its end in plan,
    by least squares, and outside of all that is built there by a ``gap`` (length); "auto" is half a
    percent of its height.
    """

    SAMPLE: ClassVar = {"at": "last"}

    at: End
    gap: Size | Literal["auto"] = "auto"
    door: Door | None = None


def require_one_wall_each(asked: Iterable[EndWall]) -> None:
    """Refuse two walls at one end."""
    ends: list[End] = []
    for number, wall in enumerate(asked):
        if wall.at in ends:
            raise InputError(
                "two end walls close one end",
                keys=(f"end_wall.{number}.at",),
                got=f'"{wall.at}" twice',
                expected='one wall at = "first", and one at = "last"',
                remedy="remove one of both",
            )
        ends.append(wall.at)


@record
class Opening:
    """The opening of a door, from the ground up."""

    width: float  # length
    height: float  # length
    # how far its middle is from that of the wall, to the right as seen from outside (length)
    offset: float


@record
class BuiltEndWall:
    """A wall that closes an end, as it stands."""

    REPORTED = (
        "at", "panels", "width", "height", "area", "clearance", "farthest", "strings",
        "shortest_string", "longest_string", "door",
    )  # fmt: skip

    at: End
    panels: int  # strips, those over its door too
    width: float  # along the ground (length)
    height: float  # of its top over the ground (length)
    area: float  # without its door
    clearance: float  # from its inner face to what is nearest of the shell, square to it (length)
    # from its inner face to that vertex of the border that is farthest from it (length)
    farthest: float
    laced: Integers  # rows and columns (K, 2) of the border's vertices that it is tied to
    lengths: Array  # of the strings (K,) that tie it, from these to its inner face (length)
    door: Opening | None  # the opening in it; None if there is none

    @property
    def strings(self) -> int:
        """How many vertices it is tied to."""
        return len(self.laced)

    @property
    def shortest_string(self) -> float:
        """The length of the shortest of them."""
        return float(self.lengths.min())

    @property
    def longest_string(self) -> float:
        """The length of the longest of them."""
        return float(self.lengths.max())
