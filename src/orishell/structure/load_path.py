"""How a shell goes as its load grows, large displacements followed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from orishell.conventions.quantities import plain
from orishell.conventions.record import record

Ending = Literal["carries", "snaps", "branches", "lost"]
"""How a path ends: under the full load; at a load that the shell cannot bear more than; where it
buckles into another shape, and nothing holds it there; where it could not be followed."""

Unfollowed = Literal["work", "lost", "hinges", "fails"]
"""Why a shell that buckles soon was not followed to its full load: that takes too long; from some
load on no balance was found; boards on hinges are not; it fails under other loads anyway."""
UNFOLLOWED: Mapping[Unfollowed, str] = {
    "work": "following it would take too long",
    "lost": "followed, no balance was found under all of them",
    "hinges": "whole boards on hinges are not followed",
    "fails": "not followed, as the shell fails anyway",
}
"""The same in words."""


@record
class LoadPath:
    """Load against displacement."""

    REPORTED = (
        "carries", "ending", "reached", "factors", "displacements", "linear_displacement",
        "linear_buckling", "imperfection",
    )  # fmt: skip

    ending: Ending  # how it ends
    reached: float  # the largest factor of the loads on it; 1 where the shell carries them
    factors: tuple[float, ...]  # factors of the loads, point by point
    displacements: tuple[float, ...]  # the largest displacement at each
    # by linear theory: the largest displacement, and the factor at which it buckles; None if it
    # does not
    linear_displacement: float
    linear_buckling: float | None
    imperfection: float = 0.0  # how far the shell is off its shape as built, at most (length)

    @property
    def carries(self) -> bool:
        """Whether it ends under the full load."""
        return self.ending == "carries"

    def in_words(self) -> str:
        """How it ends."""
        share = f"{plain(100 * self.reached, 3)} % of its loads"
        return {
            "carries": "is in balance under all loads, large displacements followed",
            "snaps": f"gives way at {share}: beyond that it snaps into another shape",
            "branches": f"buckles at {share}, and no shape beside it was found that holds",
            "lost": f"was followed to {share} only: no balance was found beyond",
        }[self.ending]
