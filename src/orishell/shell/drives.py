"""Drives as rows of the verdict say them."""

from __future__ import annotations

import numpy as np

from orishell.conventions.formatting import tidy_degrees

BELOW_MEANT = 1e-13
"""An angle that is below a round number by less than this share is that number: it is not rounded
down to the digit before."""


def degrees_below(drive: float, beside: float = np.nan) -> str:
    """A fold angle to a hundredth of a degree, or more closely to be told from another.

    It is rounded down: what is proved up to it is proved up to what is said.
    """
    one, other = tidy_degrees(drive), tidy_degrees(beside)
    said = [(_rounded_down(one, k), _rounded_down(other, k)) for k in range(2, 9)]
    clear = (first for first, second in said if first not in {"0", second})
    return f"{next(clear, said[0][0])} degrees"


def _rounded_down(degrees: float, decimals: int) -> str:
    """An angle with so many decimals at most; one that is not there stays so."""
    unit = 10.0**decimals
    down = np.floor(degrees * unit * (1 + BELOW_MEANT)) / unit
    return f"{down:.{decimals}f}".rstrip("0").rstrip(".")
