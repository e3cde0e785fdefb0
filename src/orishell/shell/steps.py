"""The steps of the work: what may be left out, who watches, and the time each takes."""

from __future__ import annotations

import time
from collections.abc import Collection
from dataclasses import field
from typing import Literal, get_args

from orishell.conventions.errors import InputError
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.record import record


class Clock:
    """A clock that takes the time of every step of the work."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}
        self._begun = self._last = time.perf_counter()

    @property
    def since_begun(self) -> float:
        """Time since it was made (s)."""
        return time.perf_counter() - self._begun

    def lap(self, step: str) -> None:
        """Note the time since the last step was done."""
        now = time.perf_counter()
        self.seconds[step] = now - self._last
        self._last = now


Step = Literal[
    "remedies", "verification", "deviation", "pack", "weight", "cutting", "stock", "structure"
]
"""What would mend a design that is refused, that packs badly, or that its loads move; whether
panels stay rigid; the distance from the surface; the smallest box and the largest thickness; own
weight; what errors of cutting do, where the file gives them; the layout on the stock; the
structure, where the file asks for it."""

STEPS: tuple[Step, ...] = get_args(Step)
"""All of them: what is left is the design, how its motion ends, and its sizes."""

MEASURES: tuple[Step, ...] = ("deviation", "pack", "weight", "cutting")
"""What is measured of a shell, and changes nothing of it."""


CONTACT, STOCK, STRUCTURE, CUTTING = (
    "contact between panels on the way",
    "the layout on the stock",
    "the structure",
    "the play that errors of cutting ask for",
)
"""What may be left out on request, of which a row says that it is not known."""
FLAPS_PLACED, GUSSETS_PLACED, PLATES_PLACED, END_WALLS_PLACED = (
    "how clipped flaps are brought to their place",
    "how gussets are brought to their place",
    "how plates are brought into boxes",
    "how end walls are brought to their place, and what holds them on the ground",
)
"""What is never examined, and has no row: the booklet says so to those who do it."""

ClashPolicy = Literal["refused", "allowed", "unexamined"]
"""If panels collide before the target: refuse the shell, allow it and say so, or do not check, for
sheets of hundreds of thousands of panels."""


@record
class Work:
    """How much is to be found out of a shell, and who watches."""

    progress: Progress = no_progress
    clash: ClashPolicy = "refused"
    skip: Collection[Step] = ()  # what is not found out of it
    briefly: bool = False  # whether of its structure only that is found which tells if it carries
    clock: Clock = field(default_factory=Clock)

    def asks(self, step: Step) -> bool:
        """Whether a step is to be done."""
        return step not in self.skip


def require_steps(skip: Collection[str]) -> None:
    """Refuse a part that there is not, which would be found out all the same.

    Raises InputError if there is one.
    """
    unknown = [skip] if isinstance(skip, str) else sorted({*skip} - {*STEPS})
    if unknown:
        raise InputError(
            "there is no such part to leave out",
            where="skip",
            got=", ".join(map(repr, unknown)),
            expected=f"some of {', '.join(STEPS)}",
        )
