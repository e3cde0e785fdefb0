"""The target surface, f slid along g, and the surface that finer and finer shells approach."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Literal

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import in_degrees
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.curves import Trace, curve_from_points, remembered, trace_curve
from orishell.design import Approached, Path, Sliding, Surface
from orishell.families.pattern import Auto
from orishell.families.shared.candidates import values
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import bisect, bisect_integers
from orishell.numerics.equals import first_largest
from orishell.polylines import (
    Zigzag,
    alternating,
    choose_depth,
    distances_to_polyline,
    place_zigzag,
    place_zigzags,
    smallest_radius,
)

LEVEL = 1e-12
"""A middle row that rises by less than this is level (radians)."""
STRAIGHT = 1e-9
"""A g that leaves the columns' normal by less than this share of its length follows it."""


def tilt_of(zigzag: Zigzag) -> float:
    """How much the middle row rises along f's zigzag (radians)."""
    return 0.0 if abs(zigzag.axis) < LEVEL else zigzag.axis


def tilted(g: Array, tilt: float) -> str:
    """How g (N, 3) is tilted in the target surface, in words; empty where it stays level."""
    high = float(np.ptp(g[:, 2]))
    if high <= STRAIGHT * float(np.ptp(g, axis=0).max()):
        return ""
    return (
        f"g's plane is tilted by {in_degrees(abs(tilt))} degrees with the axis of f's zigzag, "
        f"so g rises by {high:.4g}"
    )


def approach(f: Trace, origin: Array, g: Trace, t: complex) -> Approached | None:
    """What the shell approaches: the cylinder over f along the common normal of its columns.

    Rows shift along f, alternately to and fro, by as much as g departs from the normal. The edges
    of the zigzag limit that: the finer it is, the less can g depart.
    """
    normal = 1j * t
    points = g.points @ np.array([1, 1j])
    relative = (points - points[0]) * normal.conjugate()
    leaves = float(np.ptp(relative.imag))
    if leaves < STRAIGHT * g.length:
        return None
    ends = points[0] + np.array([relative.real.min(), relative.real.max()]) * normal
    line = curve_from_points(np.stack([ends.real, ends.imag], axis=-1), smooth=False)
    return Approached(
        f"g waves by {plain(leaves)} and rows follow it along f: finer shells come nearer to the "
        "straight cylinder over f",
        Surface(f, origin, Sliding(Path.of(trace_curve(line)), t)),
    )


End = Literal["level", "square", "untrimmed"]

MOST_ROWS = 4097
"""Rows tried in search of a zigzag."""
MORE_ROWS = (1.3, 2.0)
"""Shares of the fewest rows that have a zigzag, where no shell follows from these."""
POINTS = 200
"""Points of f that are looked at, about."""
STEEP = np.deg2rad(30.0)
"""Where f reaches its end flatter than this, no level plane cuts the shell off."""
TRIM_RANGE = (0.2, 3.0)
"""Trimmed end edges keep lengths in this range, relative to that of column 1."""


def require_zigzags(trace: Trace, rows: int, depth: float | Auto) -> list[Zigzag]:
    """Zigzags of f that turn left and right alternately; refuse a depth that has none."""
    h = choose_depth(trace, rows) if depth == "auto" else depth
    zigzags = sound_zigzags(trace, rows, h)
    if zigzags:
        return zigzags
    what = f"depth = {h:.6g}" + (' (from "auto")' if depth == "auto" else "")
    given = None if depth == "auto" else h
    best = choose_depth(trace, rows)
    candidates = _candidates(trace, rows, given)
    radius, place = smallest_radius(trace)
    if h >= radius:
        raise DesignError(
            f"{what} is too large for f: the curves at that distance from f have cusps",
            keys=("pattern.depth",),
            place=f"at parameter {trace.curve.as_drawn(place):.6g} of f",
            size="the depth must stay below f's radius of curvature, which is "
            f"{plain(radius)} there",
            candidates=candidates,
            excess=h / radius - 1,
        )
    angles = place_zigzag(trace, rows, h).angles
    row = first_largest(angles) + 1
    raise DesignError(
        f"{what} is too {'small' if h <= best else 'large'} for f: the zigzag does not turn left "
        "and right alternately",
        keys=("pattern.depth",),
        place=f"at row {row}",
        size=f"its angle there, measured from the alternating sides, is "
        f"{in_degrees(angles[row - 1])} degrees and must be below 180",
        candidates=candidates,
        excess=angles[row - 1] / np.pi - 1,
    )


@remembered
def zigzag_distance(trace: Trace, rows: int, depth: float | Auto) -> float:
    """Distance from f at which every zigzag of this depth is at least.

    That of some of f's points from the nearest of them; inner vertices are at ``depth``.
    """
    zigzags = require_zigzags(trace, rows, depth)
    points = trace.points[:: max(1, len(trace.points) // POINTS)]
    reached = (float(distances_to_polyline(points, each.vertices).max()) for each in zigzags)
    return max(min(reached), zigzags[0].depth)


def sound_zigzags(trace: Trace, rows: int, depth: float) -> list[Zigzag]:
    """Zigzags that turn alternately, no deeper than f's smallest radius, the widest reach first."""
    return place_zigzags(trace, rows, depth) if depth < smallest_radius(trace)[0] else []


def _candidates(trace: Trace, rows: int, depth: float | None) -> Iterator[Remedy]:
    """Depths to try, or numbers of rows with the depth that "auto" takes."""

    def works(rows: int, depth: float) -> bool:
        return bool(sound_zigzags(trace, rows, depth))

    best = choose_depth(trace, rows)
    if depth is not None and works(rows, best):
        limit = bisect(lambda trial: works(rows, trial), best, depth)
        yield from values("depth", min(limit, best), max(limit, best), depth)
        yield Remedy({"pattern.depth": "auto"})
    more = rows
    while more < MOST_ROWS:
        more = 2 * more + 1
        if works(more, choose_depth(trace, more)):
            fewest = bisect_integers(
                lambda half: works(2 * half + 1, choose_depth(trace, 2 * half + 1)),
                (more - 1) // 2,
                (rows - 1) // 2,
            )
            for count in (fewest, *(math.ceil(share * fewest) for share in MORE_ROWS)):
                yield Remedy({"pattern.rows": 2 * count + 1, "pattern.depth": "auto"})
            return


@record
class Trimmed:
    """The planes in which a locked shell ends, at both ends of f."""

    ends: list[End]  # their names
    trims: tuple[float, float]  # the growth by K of the end edges
    normals: list[complex | None]  # in complex numbers of f's plane


@record
class EndPlanes:
    """The planes in which a locked shell may end.

    "level" is the horizontal plane through f's end (f must be steeper there than :data:`STEEP`),
    "square" the one through it that is perpendicular to f's chord from end to end, "untrimmed"
    none: the end edges of all columns are as long as those of column 1.
    """

    # at both ends of f every plane's name and normal, and the growth by K of the end edges there
    planes: tuple[list[tuple[End, complex, float]], ...]
    lengths: tuple[float, float]  # of the end edges of column 1

    @classmethod
    def of(cls, trace: Trace, zigzag: Zigzag) -> EndPlanes:
        """Those of a zigzag of f."""
        edges = np.diff(zigzag.vertices @ np.array([1, 1j]))
        lengths = zigzag.lengths
        angles = zigzag.angles
        turning = -zigzag.first * alternating(len(angles))
        chord = complex((trace.points[-1] - trace.points[0]) @ np.array([1, 1j]))
        # a_1 and a_m of the mechanism, over the end edge's direction.
        cases = (
            (trace.heading[0], edges[0] / lengths[0], np.tan(angles[0] / 2) + 1j * turning[0], 1),
            (
                trace.arriving[-1],
                edges[-1] / lengths[-1],
                np.tan(angles[-1] / 2) - 1j * turning[-1],
                -1,
            ),
        )
        square: tuple[End, complex] = ("square", chord)
        level: tuple[End, complex] = ("level", 1j)
        planes = []
        for slope, direction, spread, sign in cases:
            steep = abs(np.sin(slope)) > np.sin(STEEP)
            planes.append(
                [
                    (
                        end,
                        normal,
                        float(sign * (direction * spread * normal.conjugate()).real / across),
                    )
                    for end, normal in ((level, square) if steep else (square,))
                    if (across := (direction * normal.conjugate()).real) != 0
                ]
            )
        return cls(tuple(planes), (float(lengths[0]), float(lengths[-1])))

    def trimmed(self, shifts: Array) -> Trimmed:
        """The first planes that keep the end edges of columns at these K in :data:`TRIM_RANGE`."""
        extremes = float(shifts.min()), float(shifts.max())
        shortest, longest = TRIM_RANGE

        def choose(
            planes: Sequence[tuple[End, complex, float]], length: float
        ) -> tuple[End, complex | None, float]:
            for plane in planes:
                shares = [1 + plane[2] * shift / length for shift in extremes]
                if shortest <= min(shares) and max(shares) <= longest:
                    return plane
            return "untrimmed", None, 0.0

        first, last = map(choose, self.planes, self.lengths)
        return Trimmed([first[0], last[0]], (first[2], last[2]), [first[1], last[1]])


def raised(g: Trace, first: complex, heading: float, tilt: float) -> Array:
    """g (N, 3) in the plane of the middle row, which is tilted about its first vertex (radians)."""
    t = np.exp(-1j * heading)
    points = g.points @ np.array([1, 1j])
    along = ((points - first) * t.conj()).real
    plan = points + (np.cos(tilt) - 1) * along * t
    return np.stack([plan.real, plan.imag, np.sin(tilt) * along], axis=-1)
