"""Why a heading is not admissible, and what would work instead."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import chain

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import as_typed, in_degrees, rounded, tidy_degrees
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.curves import Curve, Trace
from orishell.families.orthodiagonal.headings import (
    SMALLEST_EPS,
    HeadingConditions,
    holds,
    nearest_interval,
    union,
)
from orishell.families.orthodiagonal.profile import sound_zigzags
from orishell.families.shared.candidates import (
    FARTHER,
    angles,
    does_not_cross,
    part,
    sizes,
    turned_to,
    values,
)
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import bisect
from orishell.numerics.equals import first_largest, first_smallest
from orishell.polylines import Zigzag, choose_depth

DEPTHS = 40
"""Depths tried in either direction in search of one that works."""
SMALLEST_SCALE = 1e-3
"""A g that would have to be smaller than this share of itself is not offered."""
DEEPEST, SHALLOWEST = 40.0, 0.1
"""The range of the depths tried, relative to the depth asked for."""
PARTS = (0.999, 0.8, 0.5)
"""Shares tried of the part of g that turns by less than 180 degrees."""
NARROWER = Remedy({"pattern.flap": "auto"})


def refuse(
    f: Trace,
    g: Trace,
    zigzags: Sequence[Zigzag],
    demands: Sequence[HeadingConditions],
    heading: float,
    *,
    refitted: bool,
) -> DesignError:
    """The error that names the first condition that fails at a heading, and what would work.

    zigzags, demands: Zigzags of f, that of the widest reach first, and what they ask of a heading.
    refitted: Whether g's polyline is another one at another heading: no limits can be named.
    """
    zigzag, headings = zigzags[0], demands[0]
    crossing = nearest_interval(headings.crossing_intervals(), heading)
    if crossing is None:
        return _turns_too_far(g, headings)
    search = HeadingSearch(f, g.curve, zigzag, headings, heading)
    admissible = union(np.concatenate([each.intervals() for each in demands]))
    limits, nearest = "", nearest_interval(admissible, heading)
    if nearest is not None and not refitted:
        low, high = map(in_degrees, nearest)
        limits = f"; heading_deg must lie between {low} and {high}"
    if not holds(crossing, heading):
        eps = headings.eps(heading)
        worst = first_largest(np.maximum(-eps, eps - np.pi), size=np.pi)
        return does_not_cross(
            worst,
            eps[worst],
            limits,
            search.headings_of(admissible)
            if len(admissible)
            else search.at_another_heading(sum(crossing) / 2),
        )
    roomy = [each.room(heading) for each in demands if replace(each, flap=None).admit(heading)]
    if roomy:
        return _flap_too_wide(
            headings,
            max(roomy),
            chain(values("flap", 0.0, max(roomy), headings.flap or 0.0), search.run(admissible)),
        )
    free = union(np.concatenate([replace(each, flap=None).intervals() for each in demands]))
    return _rows_meet(
        zigzag,
        headings,
        heading,
        limits,
        chain(
            search.run(admissible),
            (each | NARROWER for each in search.without_flaps().run(free)) if headings.flap else (),
            (Remedy({"pattern.heading_deg": "auto"}),) if refitted else (),
        ),
    )


@record
class HeadingSearch:
    """The search for changes with which a heading is admissible, the nearest first."""

    f: Trace
    g: Curve
    zigzag: Zigzag
    headings: HeadingConditions
    heading: float

    def run(self, admissible: Array) -> Iterator[Remedy]:
        """Other headings, a smaller g, another depth; if none of these helps, two at once."""
        found = False
        for remedy in chain(self.headings_of(admissible), self.scales(), self.depths()):
            found = True
            yield remedy
        if not found:
            yield from self.at_another_depth()
            yield from self.smaller_at_the_best_depth()

    def without_flaps(self) -> HeadingSearch:
        """The search for flaps as wide as there is room for."""
        return replace(self, headings=replace(self.headings, flap=None))

    def headings_of(self, admissible: Array) -> Iterator[Remedy]:
        """Headings of the admissible interval (of k, 2) nearest to the one asked for."""
        interval = nearest_interval(admissible, self.heading)
        if interval is not None:
            yield from angles("heading_deg", *interval, self.heading)

    def scales(self) -> Iterator[Remedy]:
        """Smaller sizes of g, if one helps, from the largest that the rows admit."""

        def works(scale: float) -> bool:
            return self.headings.scaled(scale).admit(self.heading)

        if works(SMALLEST_SCALE):
            yield from sizes("g", self.g, bisect(works, SMALLEST_SCALE, 1.0))

    def depths(self) -> Iterator[Remedy]:
        """Depths from the nearest that the rows admit, if one is found."""
        asked = self.zigzag.depth

        def works(depth: float) -> bool:
            return any(
                self.headings.of(trial).admit(self.heading)
                for trial in sound_zigzags(self.f, len(self.zigzag.angles), depth)
            )

        found: list[tuple[float, float]] = []
        for end in (DEEPEST, SHALLOWEST):
            before = asked
            for trial in np.geomspace(asked, end * asked, DEPTHS)[1:]:
                if works(float(trial)):
                    found.append((bisect(works, float(trial), before), end))
                    break
                before = float(trial)
        for nearest, end in sorted(
            found, key=lambda each: rounded(abs(np.log(each[0] / asked)), 9)
        ):
            for farther in FARTHER:
                depth = nearest * farther ** np.sign(np.log(end))
                if works(depth):
                    yield Remedy({"pattern.depth": as_typed(depth, works)})

    def at_another_depth(self) -> Iterator[Remedy]:
        """Greater depths that admit any heading, with the middle of the widest interval."""
        asked = self.zigzag.depth
        for depth in np.geomspace(asked, DEEPEST * asked, DEPTHS)[1:]:
            typed = rounded(float(depth))
            for trial in sound_zigzags(self.f, len(self.zigzag.angles), typed):
                intervals = self.headings.of(trial).intervals()
                if len(intervals):
                    widest = intervals[first_largest(np.ptp(intervals, axis=1))]
                    middle = rounded(tidy_degrees(float(widest.mean())), 6)
                    yield Remedy({"pattern.depth": typed, "pattern.heading_deg": middle})
                    break

    def smaller_at_the_best_depth(self) -> Iterator[Remedy]:
        """Smaller sizes of g at the depth that "auto" takes."""
        rows = len(self.zigzag.angles)
        depth = rounded(choose_depth(self.f, rows))
        for trial in sound_zigzags(self.f, rows, depth):
            for scale in replace(self, headings=self.headings.of(trial)).scales():
                yield scale | Remedy({"pattern.depth": depth})

    def at_another_heading(self, heading: float) -> Iterator[Remedy]:
        """What works at a heading at which f's plane crosses g, without flaps that are too wide."""
        degrees = rounded(tidy_degrees(heading), 6)
        there = replace(self.without_flaps(), heading=float(np.deg2rad(degrees)))
        turned = Remedy({"pattern.heading_deg": degrees})
        if self.headings.flap:
            turned |= NARROWER
        for remedy in chain(there.scales(), there.depths(), there.smaller_at_the_best_depth()):
            yield remedy | turned


def _turns_too_far(g: Trace, headings: HeadingConditions) -> DesignError:
    direction = np.unwrap(np.angle(np.diff(headings.points)))
    start, last = float(g.t[0]), turned_to(g, np.pi - 2 * SMALLEST_EPS)
    return DesignError(
        "g turns too far: f's plane cannot cross all its chords, whatever its direction",
        size=f"its chords spread over {in_degrees(np.ptp(direction))} degrees and may spread over "
        "less than 180",
        candidates=(
            part("g", g.curve, start, start + share * (last - start))
            | Remedy({"pattern.heading_deg": "auto"})
            for share in PARTS
        ),
        excess=np.ptp(direction) / np.pi - 1,
    )


def _rows_meet(
    zigzag: Zigzag,
    headings: HeadingConditions,
    heading: float,
    limits: str,
    candidates: Iterable[Remedy],
) -> DesignError:
    growth = np.diff(np.tan(zigzag.angles / 2))[:, None]
    length = zigzag.lengths[1:-1, None]
    share = 1 + growth * headings.shifts(heading) / length
    row, column = np.unravel_index(first_smallest(share, size=1.0), share.shape)
    return DesignError(
        f"neighbouring rows meet inside the sheet: at heading_deg = {in_degrees(heading)} g runs "
        "too far along f's plane",
        keys=("pattern.heading_deg",),
        place=f"between rows {row + 1} and {row + 2} in column {column + 1}",
        size=f"the crease there would be {plain(share[row, column] * length[row, 0])} long; "
        f"in column 1 it is {plain(length[row, 0])}{limits}",
        candidates=candidates,
        excess=-share[row, column],
    )


def _flap_too_wide(
    headings: HeadingConditions, room: float, candidates: Iterable[Remedy]
) -> DesignError:
    return DesignError(
        "the flaps are too wide: neighbouring rows meet inside them",
        keys=("pattern.flap",),
        size=f"they are {plain(headings.flap or 0.0)} wide, and there is room for {plain(room)}",
        candidates=candidates,
        excess=(headings.flap or 0.0) / room - 1,
    )
