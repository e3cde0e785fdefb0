"""A design with what its sheet is asked to carry: box girders, or a second skin."""

from __future__ import annotations

from collections.abc import Mapping

from orishell.conventions.progress import Progress, no_progress
from orishell.design import Design
from orishell.design.stiffeners import Stiffeners
from orishell.locking.boxes import BoxPlace
from orishell.locking.carrier import Carrier
from orishell.locking.result import Lock
from orishell.locking.skins import SkinPlace
from orishell.motion.lattice import InnerStaircase

_KINDS: Mapping[str, type[Carrier]] = {"boxes": BoxPlace, "skin": SkinPlace}
"""What moves with the sheet, by the kind that [stiffeners] asks for."""


def with_carried(
    design: Design,
    lock: Lock,
    asked: Stiffeners | None,
    tolerance: float,
    *,
    examined: bool = True,
    inner: InnerStaircase | None = None,
    progress: Progress = no_progress,
) -> tuple[Design, Lock]:
    """The design with what it is asked to carry, if anything, and how its motion ends then.

    lock: How the motion of the sheet ends, with its boards.
    tolerance: Distance at which panels touch, relative to the flat sheet's diagonal.
    examined: Whether contact is looked for.
    inner: The staircase that a second skin follows; None if it is the sheet's own.

    Raises InputError if it cannot be asked for: there are no such rows, or panels are whole boards.
    Raises DesignError if there is no room for it.
    """
    kind = None if asked is None else _KINDS.get(asked.kind)
    if asked is None or kind is None:
        return design, lock
    place = kind(design, lock, asked, tolerance, examined=examined, inner=inner)
    return place.carried(progress)
