"""The stiffness of creases in words."""

from __future__ import annotations

from math import isinf
from typing import Literal

Stiffness = float | Literal["free", "rigid"]
"""Of creases: moment per length and angle (N), 0 and infinite said in words."""


def stiffness_in_words(stiffness: float) -> Stiffness:
    """A stiffness of creases (force per radian), 0 and infinite in words."""
    return "free" if not stiffness else "rigid" if isinf(stiffness) else stiffness


def creases_in_words(creases: Stiffness) -> str:
    """Creases of a stiffness, as the name of a case has them."""
    return f"{creases} creases" if isinstance(creases, str) else f"creases of {creases:g} N"
