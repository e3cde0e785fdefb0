"""What a family hands over when a design succeeds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from orishell.motion import Mechanism
from orishell.polylines import Closeness

Array = NDArray[np.float64]

FlapSide = Literal["start", "end"]
"""To which end of f a flap folds."""

Parameter = float | int | str | list[float] | list[str]


@dataclass(frozen=True, slots=True, eq=False)
class Design:
    """A feasible design.

    Parameters
    ----------
    mechanism
        The folding sheet.
    parameters
        What the family used and found, in the units of files: degrees (``_deg``) and the unit of
        the curves.
    targets
        The target curves "f" and "g" in world coordinates (N, 3), placed as the locked shell
        meets them.
    closeness
        Distance of the polylines the shell locks on to the target curves, by the same names.
    warnings
        Sentences a user should read: the design is made, but may not be what was meant.
    lock_cause
        What ends the motion: "flaps" that clash, or a "crease" that is folded flat.
    lock_drive
        Drive at which it would end if it is not stopped at a stage before (radians), or None for
        the mechanism's ``lock_drive``.
    """

    mechanism: Mechanism
    parameters: Mapping[str, Parameter]
    targets: Mapping[str, Array]
    closeness: Mapping[str, Closeness]
    warnings: tuple[str, ...]
    lock_cause: Literal["flaps", "crease"] = "flaps"
    lock_drive: float | None = None
