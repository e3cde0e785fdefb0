"""How a shell is deployed: what it is opened or folded up from, and what holds it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from orishell.motion.grid import VertexPair

Start = Literal["flat", "pack"]
"""What a shell is folded up or opened from."""
Attachment = Literal["folded", "clipped"]
"""Whether flaps are part of the folding sheet, or put on at the target."""


@dataclass(frozen=True, slots=True)
class Deployment:
    """How a shell is deployed.

    Parameters
    ----------
    start
        The shell is folded up from the flat sheet, or opened from its pack.
    flap_attachment
        Flaps are part of the folding sheet, whose motion they end at the target; or boards that
        are clipped on there, so that the sheet can be closed further.
    largest_fold
        How far hinges close (radians).
    ties
        What keeps the shell from opening beyond its target: nothing; ties between the feet of
        every column; or ties between pairs of vertices.
    """

    start: Start = "flat"
    flap_attachment: Attachment = "folded"
    largest_fold: float = np.pi
    ties: Literal["none", "feet"] | tuple[VertexPair, ...] = "none"


FROM_FLAT = Deployment()
"""As in the paper: folded up from the flat sheet until its flaps stop it."""
