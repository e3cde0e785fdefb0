"""The target surface, f slid along g, and the surface that finer and finer shells approach."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Literal

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import in_degrees
from orishell.conventions.quantities import plain
from orishell.curves import Trace, curve_from_points, remembered, trace_curve
from orishell.design import Approached, Path, Sliding, Surface
from orishell.families.pattern import Auto
from orishell.families.shared.candidates import values
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import bisect, bisect_integers
from orishell.polylines import (
    Zigzag,
    alternating,
    choose_depth,
    distances_to_polyline,
    place_zigzag,
    place_zigzags,
    smallest_radius,
)

STRAIGHT = 1e-9
"""A g that leaves the columns' normal by less than this share of its length follows it."""


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
    row = int(angles.argmax()) + 1
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


def trim_ends(
    trace: Trace, zigzag: Zigzag, shifts: Array
) -> tuple[list[End], tuple[float, float], list[complex | None]]:
    """The planes in which the locked shell ends, the growth by K of the end edges, and the normals.

    At both ends of f the first of these that keeps end edges in :data:`TRIM_RANGE`, whatever K of
    the columns that are to end there: "level" is the horizontal plane through f's end (f must be
    steeper there than :data:`STEEP`), "square" the one through it that is perpendicular to f's
    chord from end to end, "untrimmed" none: the end edges of all columns are as long as those of
    column 1. Normals of the planes are complex numbers of f's plane.
    """
    edges = np.diff(zigzag.vertices @ np.array([1, 1j]))
    lengths = np.abs(edges)
    angles = zigzag.angles
    turning = -zigzag.first * alternating(len(angles))
    chord = (trace.points[-1] - trace.points[0]) @ np.array([1, 1j])
    # a_1 and a_m of the mechanism, over the end edge's direction.
    cases = (
        (edges[0] / lengths[0], np.tan(angles[0] / 2) + 1j * turning[0], lengths[0]),
        (edges[-1] / lengths[-1], np.tan(angles[-1] / 2) - 1j * turning[-1], -lengths[-1]),
    )
    square: tuple[End, complex] = ("square", complex(chord))
    level: tuple[End, complex] = ("level", 1j)
    ends: list[End] = []
    trims: list[float] = []
    for slope, case in zip((trace.heading[0], trace.arriving[-1]), cases, strict=True):
        planes = (level, square) if abs(np.sin(slope)) > np.sin(STEEP) else (square,)
        end, trim = _trim(*case, shifts, planes)
        ends.append(end)
        trims.append(trim)
    normals = {"level": level[1], "square": square[1], "untrimmed": None}
    return ends, (trims[0], trims[1]), [normals[end] for end in ends]


def _trim(
    direction: complex,
    spread: complex,
    length: float,
    shifts: Array,
    planes: Sequence[tuple[End, complex]],
) -> tuple[End, float]:
    """The first plane that leaves all end edges' lengths in range, and their growth by K."""
    sign = np.sign(length)
    for end, normal in planes:
        across = (direction * normal.conjugate()).real
        if across == 0:
            continue
        trim = float(sign * (direction * spread * normal.conjugate()).real / across)
        share = 1 + trim * shifts / abs(length)
        if TRIM_RANGE[0] <= share.min() and share.max() <= TRIM_RANGE[1]:
            return end, trim
    return "untrimmed", 0.0
