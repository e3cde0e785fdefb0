"""The middle row on g, and the planes of the columns."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import chain
from typing import Literal

import numpy as np

from orishell.conventions.errors import Remedy
from orishell.conventions.formatting import in_degrees, rounded, tidy_degrees
from orishell.conventions.record import record
from orishell.curves import Trace
from orishell.curves.plane import normals_at
from orishell.families.shared.candidates import angles, does_not_cross
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import bisect_integers, largest_below
from orishell.numerics.equals import first_largest
from orishell.polylines import Chords, Placement, Spacing, alternating, place_chords

Planes = Literal["tangent", "bisector"]
"""What the planes of columns 2 ... n-1 follow: g's tangent, or the angle of its polyline."""

MORE_COLUMNS = (1.25, 1.6, 2.5)
"""Shares of the fewest columns that are enough, where these are not."""
SHALLOWER = (0.9, 0.6, 0.3)
"""Shares of the largest depth that is possible, where one is too large."""
LEAST_DEPTH = 1e-4
"""The share of a depth below which none is looked for."""


@record
class Row:
    """The middle row on g's polyline."""

    chords: Chords  # g's polyline
    # directions (n,) that the planes follow at the vertices (radians): g's own, or those that
    # bisect the angles of its polyline, but for its ends
    heading: Array
    plane: float  # angle from f's plane to these (radians)
    planes: Planes  # which of the two
    off: float  # the largest angle between these and g's own (radians)
    # how g's vertices were placed
    trace: Trace
    spacing: Spacing
    placement: Placement
    depth: float = 0.0  # how far its vertices lie off g, to either side in turn

    @classmethod
    def on(
        cls,
        trace: Trace,
        columns: int,
        plane: float,
        planes: Planes,
        *,
        spacing: Spacing,
        placement: Placement,
        depth: float = 0.0,
    ) -> Row:
        """Place the vertices along g, or to its left and right in turn where there is a depth."""
        chords = place_chords(trace, columns, spacing, placement)
        if depth:
            beside = alternating(columns)[:, None] * normals_at(trace, chords.parameters)
            chords = replace(chords, vertices=chords.vertices + depth * beside)
        heading = trace.heading_at(chords.parameters)
        off = np.zeros(len(heading))
        if planes == "bisector":
            edge = np.diff(chords.vertices @ np.array([1, 1j]))
            turn = np.angle(edge[1:] * edge[:-1].conj())
            off[1:-1] = _wrapped(np.angle(edge[:-1]) + turn / 2 - heading[1:-1])
        most = float(np.abs(off).max())
        return cls(chords, heading + off, plane, planes, most, trace, spacing, placement, depth)

    def turns(self) -> Array:
        """Angles (2, n-1) of every chord from g's direction at its first and its last vertex."""
        chord = np.diff(self.chords.vertices, axis=0)
        direction = np.arctan2(chord[:, 1], chord[:, 0])
        return _wrapped(direction - np.stack([self.heading[:-1], self.heading[1:]]))

    def require_crossing(self, *, turnable: bool = True) -> None:
        """Refuse chords that do not run from one column plane to the next (0 < delta < pi).

        Parameters
        ----------
        turnable
            Whether a design file can turn the planes: by plane_deg.
        """
        delta = self.turns() + self.plane
        outside = np.maximum(-delta, delta - np.pi)
        worst = np.unravel_index(first_largest(outside, size=np.pi), outside.shape)
        if outside[worst] < 0:
            return
        low, high = _planes_that_cross(self.turns())
        limits, turnable = "", turnable and self.planes == "tangent"
        candidates = chain(self._less_depth(), self._enough_columns(turnable=turnable))
        if turnable and low < high:
            limits = f"; plane_deg must lie between {in_degrees(low)} and {in_degrees(high)}"
            candidates = chain(angles("plane_deg", low, high, self.plane))
        elif turnable:
            limits = "; no plane_deg fits all columns"
        raise does_not_cross(int(worst[1]), delta[worst], limits, candidates)

    def _less_depth(self) -> Iterator[Remedy]:
        """The depths just below the largest that is possible."""

        def works(depth: float) -> bool:
            row = Row.on(
                self.trace,
                len(self.heading),
                self.plane,
                self.planes,
                spacing=self.spacing,
                placement=self.placement,
                depth=depth,
            )
            return row.crosses()

        largest = largest_below(works, self.depth, smallest=LEAST_DEPTH) if self.depth else None
        if largest is not None:
            yield from (Remedy({"pattern.depth": rounded(less * largest, 2)}) for less in SHALLOWER)

    def crosses(self) -> bool:
        """Whether all chords run from one column plane to the next."""
        delta = self.turns() + self.plane
        return bool((delta > 0).all() and (delta < np.pi).all())

    def _enough_columns(self, *, turnable: bool) -> Iterator[Remedy]:
        count = len(self.heading)

        def with_columns(columns: int, spacing: Spacing = self.spacing) -> Row:
            return Row.on(
                self.trace,
                columns,
                self.plane,
                self.planes,
                spacing=spacing,
                placement=self.placement,
                depth=self.depth,
            )

        def works(columns: int, spacing: Spacing = self.spacing) -> bool:
            return with_columns(columns, spacing).crosses()

        # Powers of two, so that refusals of one g try the same numbers and find them remembered.
        columns = 2 ** count.bit_length()
        for _ in range(8):
            if works(columns):
                fewest = bisect_integers(works, columns, columns // 2)
                if fewest > count:
                    # More columns than are just enough leave more room for the panels.
                    for enough in (fewest, *(math.ceil(more * fewest) for more in MORE_COLUMNS)):
                        yield Remedy({"pattern.columns": enough})
                    return
            columns *= 2
        columns //= 2
        for more in (count, columns):
            if self.spacing == "equal" and works(more, "curvature"):
                yield Remedy({"pattern.spacing": "curvature", "pattern.columns": more})
        least, most = _planes_that_cross(with_columns(columns).turns())
        if turnable and least < most:
            plane = rounded(tidy_degrees(0.5 * (least + most)), 6)
            yield Remedy({"pattern.plane_deg": plane, "pattern.columns": columns})


def _planes_that_cross(turns: Array) -> tuple[float, float]:
    """The interval of the angle ``plane`` in which f's plane crosses chords of these turns."""
    return float((-turns).max()), float(np.pi - turns.max())


def _wrapped(angle: Array) -> Array:
    return np.asarray(np.mod(angle + np.pi, 2 * np.pi) - np.pi)
