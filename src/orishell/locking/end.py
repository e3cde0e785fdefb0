"""How the motion of what is asked for ends."""

from __future__ import annotations

from collections.abc import Callable

from orishell.design import Design
from orishell.locking.flaps import fit_flaps
from orishell.locking.lock import Lock
from orishell.locking.open_end import end_motion
from orishell.locking.request import Request


def end_of(
    request: Request,
    design: Design,
    *,
    allow_clash: bool = False,
    advanced: Callable[[float], None] | None = None,
) -> tuple[Design, Lock]:
    """Find how a design's motion ends: at its target, or without one as far as it folds.

    Parameters
    ----------
    request
        What is asked for.
    design
        What was made of it.
    allow_clash
        Return the design even if panels meet before its target, or the stage that is asked for.
    advanced
        Called with the share of the path that is done.

    Raises
    ------
    ClashError
        If panels meet before: which, and where.
    """
    if request.target is None:
        return end_motion(
            design, tolerance=request.tolerance, allow_clash=allow_clash, advanced=advanced
        )
    return fit_flaps(request, design, allow_clash=allow_clash, advanced=advanced)
