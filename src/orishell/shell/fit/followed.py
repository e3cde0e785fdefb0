"""Sheets of fits that begin with another one nearby, while factors of their target are looked for.

A fit takes long, and sizes of sheets that are fitted anew leap by millimetres from one factor to
the next. Those of sheets that begin with one nearby change as the target does.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from orishell.design import Design
from orishell.numerics.arrays import Array
from orishell.numerics.broyden import Sizing
from orishell.shell.designed import designed

if TYPE_CHECKING:
    from orishell.shell.fit.search import SizeFit

ROUGH = 0.003
"""Sizes may be off by this share of the least before all sheets begin with the last fit."""
NEARBY = 1.05
"""By such factors a target may be scaled for its sheet to begin with the one before: where it grew
by 1.1 again and again, sheets ran into their limits and stuck there."""


def near_fit(search: SizeFit, start: Array) -> Array:
    """Factors near those that a search looks for, and a fit with whose sheet those there begin.

    The start, where nothing is fitted.
    """
    first = designed(search.scaled(start))
    if first.fitted is None:
        return start
    followed = _Followed(search, start, first)
    asked = search.asked[: len(start)]
    rough = Sizing(followed.measure, asked, ROUGH * float(search.asked.min()))
    rough.run(start)
    search.begin_again({}, followed.design)
    return rough.found[0]


@dataclass(slots=True)
class _Followed:
    """Sizes of sheets that begin with the last one that was fitted anew, where that is near."""

    search: SizeFit
    factors: Array  # of that sheet (k,)
    design: Design

    def measure(self, factors: Array) -> Array | None:
        """Sizes of a sheet (k,); None if there is none."""
        near = np.abs(np.log(factors / self.factors)).max() <= np.log(NEARBY)
        before = self.design if near else None
        made = self.search.tried(replace(self.search.scaled(factors), before=before))
        if made is None:
            return None
        design, found = made
        if not near:
            self.factors, self.design = factors, design
        return None if (found <= 0).any() else found[: len(factors)]
