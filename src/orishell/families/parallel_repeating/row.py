"""The curve g that f is swept along: the middle row and the planes of the columns."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from orishell.conventions.formatting import in_degrees, rounded, tidy_degrees
from orishell.curves import Trace
from orishell.errors import DesignError, Remedy
from orishell.families.candidates import angles
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import bisect_integers
from orishell.polylines import Chords, Placement, Spacing, place_chords

MORE_COLUMNS = (1.25, 1.6, 2.5)
"""Shares of the fewest columns that are enough, where these are not."""


@dataclass(frozen=True, slots=True, eq=False)
class Row:
    """The middle row on g's polyline.

    Parameters
    ----------
    chords
        g's polyline.
    heading
        g's directions (n,) at its vertices (radians).
    plane
        Angle from f's plane to g's tangent (radians).
    """

    chords: Chords
    heading: Array
    plane: float

    @property
    def parameters(self) -> Array:
        """Parameters (n,) on g of the vertices."""
        return self.chords.parameters

    @property
    def vertices(self) -> Array:
        """Vertices (n, 2) of g's polyline."""
        return self.chords.vertices

    @classmethod
    def on(
        cls, trace: Trace, columns: int, plane: float, spacing: Spacing, placement: Placement
    ) -> Row:
        """Place the vertices along g."""
        chords = place_chords(trace, columns, spacing, placement)
        return cls(chords, trace.heading_at(chords.parameters), plane)

    def turns(self) -> Array:
        """Angles (2, n-1) of every chord from g's direction at its first and its last vertex."""
        chord = np.diff(self.vertices, axis=0)
        direction = np.arctan2(chord[:, 1], chord[:, 0])
        turn = direction - np.stack([self.heading[:-1], self.heading[1:]])
        wrapped: Array = np.mod(turn + np.pi, 2 * np.pi) - np.pi
        return wrapped

    def require_crossing(self, trace: Trace, spacing: Spacing, placement: Placement) -> None:
        """Refuse chords that do not run from one column plane to the next (0 < delta < pi)."""
        delta = self.turns() + self.plane
        outside = np.maximum(-delta, delta - np.pi)
        worst = np.unravel_index(int(outside.argmax()), outside.shape)
        if outside[worst] < 0:
            return
        column = int(worst[1]) + 1
        low, high = float((-self.turns()).max()), float(np.pi - self.turns().max())
        limits = (
            f"; plane_deg must lie between {in_degrees(low)} and {in_degrees(high)}"
            if low < high
            else "; no plane_deg fits all columns"
        )
        raise DesignError(
            "f's plane does not cross the chord of g",
            place=f"between columns {column} and {column + 1}",
            size=f"the angle between them is {in_degrees(delta[worst])} degrees, and must lie "
            "between 0 and 180" + limits,
            candidates=angles("plane_deg", low, high, self.plane)
            if low < high
            else self._enough_columns(trace, spacing, placement),
        )

    def _enough_columns(
        self, trace: Trace, spacing: Spacing, placement: Placement
    ) -> Iterator[Remedy]:
        def works(columns: int, spacing: Spacing = spacing) -> bool:
            row = Row.on(trace, columns, self.plane, spacing, placement)
            delta = row.turns() + self.plane
            return bool((delta > 0).all() and (delta < np.pi).all())

        # Powers of two, so that refusals of one g try the same numbers and find them remembered.
        columns = 2 ** len(self.vertices).bit_length()
        for _ in range(8):
            if works(columns):
                fewest = bisect_integers(works, columns, columns // 2)
                if fewest > len(self.vertices):
                    # More columns than are just enough leave more room for the panels.
                    yield from (
                        Remedy({"pattern.columns": count})
                        for count in (fewest, *(math.ceil(more * fewest) for more in MORE_COLUMNS))
                    )
                    return
            columns *= 2
        columns //= 2
        for more in (len(self.vertices), columns):
            if spacing == "equal" and works(more, "curvature"):
                yield Remedy({"pattern.spacing": "curvature", "pattern.columns": more})
        turns = Row.on(trace, columns, self.plane, spacing, placement).turns()
        least, most = float((-turns).max()), float(np.pi - turns.max())
        if least < most:
            plane = rounded(tidy_degrees(0.5 * (least + most)), 6)
            yield Remedy({"pattern.plane_deg": plane, "pattern.columns": columns})
