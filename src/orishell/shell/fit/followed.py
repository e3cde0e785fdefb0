"""Sheets of fits that begin with another one nearby, while factors of their target are looked for.

A fit takes long, and sizes of sheets that are fitted anew leap by millimetres from one factor to
the next. Those of sheets that begin with one nearby change as the target does.
"""

from __future__ import annotations

from collections.abc import Iterator
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


def near_fits(search: SizeFit, start: Array) -> Iterator[tuple[Array, Design | None]]:
    """Factors near those that a search looks for, and a fit with whose sheet those there begin.

    The start, where nothing is fitted. First from a fit just there, which may be nearer to its
    surface; then, where sizes of that leap, from the one that led there.
    """
    first = designed(search.scaled(start))
    if first.fitted is None:
        yield start, None
        return
    followed = _Followed(search, start, first)
    asked = search.asked[: len(start)]
    rough = Sizing(followed.measure, asked, ROUGH * float(search.asked.min()))
    rough.run(start)
    (found, _), led = rough.found, followed.design
    if (found != followed.factors).any() and followed.fit(found) is not None:
        yield found, followed.design
    yield found, led


@dataclass(slots=True)
class _Followed:
    """Sizes of sheets that begin with the last one that was fitted anew, where that is near."""

    search: SizeFit
    factors: Array  # of that sheet (k,)
    design: Design

    def measure(self, factors: Array) -> Array | None:
        """Sizes of a sheet (k,); None if there is none."""
        if np.abs(np.log(factors / self.factors)).max() > np.log(NEARBY):
            found = self.fit(factors)
        else:
            made = self.search.tried(replace(self.search.scaled(factors), before=self.design))
            found = None if made is None else made[1]
        return None if found is None or (found <= 0).any() else found[: len(factors)]

    def fit(self, factors: Array) -> Array | None:
        """Sizes (n,) of a sheet that is fitted anew, with which others begin; None if none is."""
        made = self.search.tried(self.search.scaled(factors))
        if made is None:
            return None
        self.factors, (self.design, found) = factors, made
        return found
