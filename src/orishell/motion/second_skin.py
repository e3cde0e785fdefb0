"""A second skin under a sheet, and walls between both: what all kinds of them say.

A sheet that can have one says which (:class:`Skinned`): one on a lattice a staircase of its two
directions (:mod:`~orishell.motion.skins`), one whose rows stay level its own image, straight below
it (:mod:`~orishell.motion.level_skins`).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol, runtime_checkable

from orishell.conventions.record import record
from orishell.motion.carried import Carried
from orishell.motion.mechanism import Mechanism
from orishell.numerics.arrays import Array, Integers

ROOM = 0.2
"""A wall stands where panels of both skins face each other over this share of one's edge."""
HALF = 0.5
"""Where nobody says how far, a skin is moved by this share of the shortest edge."""
SLIVER = 1e-6
"""What is left of an edge is nothing if it is this share of it."""
OUTER, INNER = 0, 1
"""Parts of a sheet with a second skin: its own panels, and those of the second."""


@record
class Wall:
    """Where a wall may stand: between a row of panels and the strip of the other skin below it."""

    row: int  # of panels of the sheet
    strip: int  # of the second skin
    outer: Array  # its place on the sheet, in coordinates of the kind of skin
    inner: Array  # and on the other skin


class SecondSkin(Protocol):
    """A second skin of a sheet."""

    @property
    def sheet(self) -> Mechanism:
        """The sheet."""

    @property
    def columns(self) -> slice:
        """The columns of vertices of the sheet that it is over."""

    @property
    def parallel(self) -> Integers:
        """Rows (K-1,) of panels of the sheet that its strips are parallel to."""

    @property
    def names(self) -> Integers:
        """Numbers that its strips (K-1,) are called by."""

    @property
    def moved(self) -> bool:
        """Whether it is the sheet, moved; else it follows a curve of its own."""

    @property
    def joined_at(self) -> float:
        """The share of the target's drive from which on there is room for it."""

    @property
    def too_far(self) -> str:
        """How far it is from the sheet against how far it may be, in words."""

    def walls(self) -> tuple[Wall, ...]:
        """Where walls may stand, in the order of rows of panels; none crosses another one."""

    def distances(self) -> tuple[float, float]:
        """How far panels of both are apart at the target at least, and those at walls at most."""

    def carried(self, walls: Sequence[Wall]) -> tuple[Carried, ...]:
        """The second skin, and its walls."""


@runtime_checkable
class Skinned(Protocol):
    """A sheet that can have a second skin."""

    def second_skin(self, columns: slice, gap: float | None) -> SecondSkin:
        """The one over columns of vertices that is nowhere nearer at the target than a gap.

        Without a gap it is moved by half of the shortest edge (length).
        """
