"""Why a heading is not admissible, and what would work instead."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from orishell.curves import Trace
from orishell.curves.jets import Array
from orishell.errors import DesignError
from orishell.families.orthodiagonal.headings import (
    SMALLEST_EPS,
    Headings,
    holds,
    nearest_interval,
    union,
)
from orishell.families.orthodiagonal.profile import as_typed, bisect, sound_zigzags
from orishell.polylines import Zigzag, choose_depth
from orishell.quoting import ROUNDING, in_degrees, inside

DEPTHS = 40
"""Depths tried in either direction in search of one that works."""
SMALLEST_SCALE = 1e-3
"""A g that would have to be smaller than this share of itself is not offered."""
DEEPEST, SHALLOWEST = 40.0, 0.1
"""The range of the depths tried, relative to the depth asked for."""


def refuse(
    f: Trace, g: Trace, zigzags: Sequence[Zigzag], demands: Sequence[Headings], heading: float
) -> DesignError:
    """The first condition that fails at a heading.

    Parameters
    ----------
    f, g
        The target curves.
    zigzags, demands
        Zigzags of f, that of the widest reach first, and what they ask of a heading.
    heading
        The heading that none of them admits (radians).
    """
    zigzag, headings = zigzags[0], demands[0]
    crossing = nearest_interval(headings.crossing_intervals(), heading)
    if crossing is None:
        return _turns_too_far(g, headings)
    admissible = union(np.concatenate([each.intervals() for each in demands]))
    if not holds(crossing, heading):
        interval = nearest_interval(admissible, heading)
        offer = (
            _at_another_heading(f, zigzag, headings, sum(crossing) / 2)
            if interval is None
            else _interval(interval)
        )
        return _does_not_cross(headings, heading, offer)
    remedies = _remedies(f, zigzag, headings, admissible, heading)
    roomy = [each.room(heading) for each in demands if replace(each, flap=None).admit(heading)]
    if roomy:
        return _flap_too_wide(headings, max(roomy), remedies)
    if not remedies:
        without = [replace(each, flap=None) for each in demands]
        free = union(np.concatenate([each.intervals() for each in without]))
        remedies = [
            f'{remedy} with flap = "auto"'
            for remedy in _remedies(f, zigzag, without[0], free, heading)
        ]
    return _rows_meet(zigzag, headings, heading, remedies)


def _remedies(
    f: Trace, zigzag: Zigzag, headings: Headings, admissible: Array, heading: float
) -> list[str]:
    """Whatever works instead: other headings, a smaller g, another depth."""
    interval = nearest_interval(admissible, heading)
    found = [_interval(interval)] if interval is not None else []
    found += _scale(headings, heading) + _depth(f, zigzag, headings, heading)
    return (
        found
        or _at_another_depth(f, zigzag, headings)
        or _smaller_at_the_best_depth(f, zigzag, headings, heading)
    )


def _at_another_depth(f: Trace, zigzag: Zigzag, headings: Headings) -> list[str]:
    """The nearest greater depth that admits any heading, with the middle of the widest interval."""
    for depth in np.geomspace(zigzag.depth, DEEPEST * zigzag.depth, DEPTHS)[1:]:
        typed = float(f"{depth:.4g}")
        for trial in sound_zigzags(f, len(zigzag.angles), typed):
            intervals = headings.of(trial).intervals()
            if len(intervals):
                widest = intervals[int(np.ptp(intervals, axis=1).argmax())]
                middle = in_degrees(float(widest.mean()))
                if headings.of(trial).admit(np.deg2rad(float(middle))):
                    return [f"depth = {typed:g} with heading_deg = {middle}"]
    return []


def _smaller_at_the_best_depth(
    f: Trace, zigzag: Zigzag, headings: Headings, heading: float
) -> list[str]:
    """The largest scale of g at the depth that "auto" takes: what is left if nothing else helps."""
    rows = len(zigzag.angles)
    depth = float(f"{choose_depth(f, rows):.4g}")
    for trial in sound_zigzags(f, rows, depth):
        found = _scale(headings.of(trial), heading)
        if found:
            return [f"{found[0]} with depth = {depth:g}"]
    return []


def _at_another_heading(f: Trace, zigzag: Zigzag, headings: Headings, heading: float) -> str:
    """What works at a heading at which f's plane crosses g, without flaps that are too wide."""
    heading = np.deg2rad(float(in_degrees(heading)))
    without = replace(headings, flap=None)
    found = _scale(without, heading) + _depth(f, zigzag, without, heading)
    found = found or _smaller_at_the_best_depth(f, zigzag, without, heading)
    if not found:
        return "a smaller g"
    flap = "" if headings.flap == 0 else ' and flap = "auto"'
    return f"{found[0]} with heading_deg = {in_degrees(heading)}{flap}"


def _interval(interval: tuple[float, float]) -> str:
    low, high = interval
    margin = ROUNDING * (high - low)
    first, last = (
        as_typed(float(np.rad2deg(angle)), lambda typed: holds(interval, np.deg2rad(typed)), 6)
        for angle in (low + margin, high - margin)
    )
    return f"heading_deg between {first} and {last}"


def _turns_too_far(g: Trace, headings: Headings) -> DesignError:
    direction = np.unwrap(np.angle(np.diff(headings.points)))
    both = np.stack([g.heading, g.arriving])
    so_far = np.maximum.accumulate(both.max(axis=0)) - np.minimum.accumulate(both.min(axis=0))
    last = g.t[np.flatnonzero(so_far < np.pi - 2 * SMALLEST_EPS)[-1]]
    low, high = g.curve.drawn_part(g.t[0], inside(last, g.t[0]))
    return DesignError(
        "g turns too far: no plane of f crosses all its chords",
        size=f"its chords spread over {in_degrees(np.ptp(direction))} degrees and may spread over "
        "less than 180",
        nearest=f'the part of g from parameter {low:.6g} to {high:.6g} with heading_deg = "auto"',
    )


def _does_not_cross(headings: Headings, heading: float, nearest: str) -> DesignError:
    eps = headings.eps(heading)
    worst = int(np.argmax(np.maximum(-eps, eps - np.pi)))
    return DesignError(
        "f's plane does not cross the chord of g",
        place=f"between columns {worst + 1} and {worst + 2}",
        size=f"the angle between them is {in_degrees(eps[worst])} degrees, and must lie between "
        "0 and 180",
        nearest=nearest,
    )


def _rows_meet(
    zigzag: Zigzag, headings: Headings, heading: float, remedies: list[str]
) -> DesignError:
    growth = np.diff(np.tan(zigzag.angles / 2))[:, None]
    length = zigzag.lengths[1:-1, None]
    share = 1 + growth * headings.shifts(heading) / length
    row, column = np.unravel_index(int(share.argmin()), share.shape)
    return DesignError(
        f"neighbouring rows meet inside the sheet: at heading_deg = {in_degrees(heading)} g runs "
        "too far along f's plane",
        place=f"between rows {row + 1} and {row + 2} in column {column + 1}",
        size=f"the crease there would be {share[row, column] * length[row, 0]:.4g} long, "
        f"in column 1 it is {length[row, 0]:.4g}",
        nearest=", or ".join(remedies),
    )


def _flap_too_wide(headings: Headings, room: float, remedies: list[str]) -> DesignError:
    return DesignError(
        "the flaps are too wide: neighbouring rows meet inside them",
        size=f"they are {headings.flap:.4g} wide, and there is room for {room:.4g}",
        nearest=", or ".join([f"flap = {inside(room, 0.0):.4g}", *remedies]),
    )


def _scale(headings: Headings, heading: float) -> list[str]:
    """The largest scale of g that works at a heading, if a smaller g helps."""

    def works(scale: float) -> bool:
        return headings.scaled(scale).admit(heading)

    if not works(SMALLEST_SCALE):
        return []
    scale = as_typed(inside(bisect(SMALLEST_SCALE, 1.0, works), 0.0), works)
    return [f"scale in [target.g] times {scale} (1 where none is given)"]


def _depth(f: Trace, zigzag: Zigzag, headings: Headings, heading: float) -> list[str]:
    """The nearest depth that works at a heading, if one is found."""

    def works(depth: float) -> bool:
        return any(
            headings.of(trial).admit(heading)
            for trial in sound_zigzags(f, len(zigzag.angles), depth)
        )

    found: list[float] = []
    for end in (DEEPEST, SHALLOWEST):
        before = zigzag.depth
        for trial in np.geomspace(zigzag.depth, end * zigzag.depth, DEPTHS)[1:]:
            if works(float(trial)):
                found.append(bisect(float(trial), before, works))
                break
            before = float(trial)
    nearest = min(found, key=lambda depth: abs(np.log(depth / zigzag.depth)), default=None)
    return [] if nearest is None else [f"depth = {as_typed(nearest, works)}"]
