"""Refusals that families share, and changes to the design file worth trying (not in the paper).

Among them are slips of the pen that are legal: radians for degrees, a curve in another unit than
the other. A shell that is made of them draws a warning; where one is refused, what may have been
meant is tried first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import chain
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.errors import DesignError, Remedy, Value
from orishell.conventions.formatting import INSIDE_LIMIT, between, in_degrees, rounded, tidy_degrees
from orishell.conventions.quantities import plain
from orishell.curves import Curve, Trace
from orishell.design import Design

if TYPE_CHECKING:
    from orishell.families.pattern import Pattern

FARTHER = (1 + INSIDE_LIMIT, 1.1, 1.4, 2.0)
"""Sizes of a curve are tried beyond their limit by these factors."""


def values(key: str, low: float, high: float, wanted: float) -> Iterator[Remedy]:
    """Values of a key of [pattern] to try, within an open interval; none if it is empty."""
    if low < high:
        yield from (Remedy({f"pattern.{key}": value}) for value in between(low, high, wanted))


def angles(key: str, low: float, high: float, wanted: float) -> Iterator[Remedy]:
    """Values of a key in degrees to try; the interval and what was asked for are in radians."""
    yield from values(key, tidy_degrees(low), tidy_degrees(high), tidy_degrees(wanted))


def sizes(name: str, curve: Curve, factor: float) -> Iterator[Remedy]:
    """Sizes of f or g to try, beyond a limit that it must not reach.

    At the limit the curve is ``factor`` times as large: below 1 it must become smaller.
    """
    for farther in FARTHER:
        share = factor / farther if factor < 1 else factor * farther
        yield Remedy({f"target.{name}.scale": curve.scale_times(share)})


def part(name: str, curve: Curve, start: float, stop: float) -> Remedy:
    """The change that keeps only a part of f or g, between two of its parameters."""
    low, high = curve.drawn_part(start, stop)
    return Remedy({f"target.{name}.{curve.key}": [rounded(low, 6), rounded(high, 6)]})


def fewer(key: str, count: int) -> Iterator[Remedy]:
    """Smaller odd numbers of "rows" or "columns" to try."""
    while count > 3:
        count = count // 4 * 2 + 1
        yield Remedy({f"pattern.{key}": count})


def smaller(rows: int, columns: int) -> Iterator[Remedy]:
    """Smaller sheets to try: fewer rows, then fewer columns."""
    yield from chain(fewer("rows", rows), fewer("columns", columns))


def turned_to(trace: Trace, spread: float) -> float:
    """The parameter up to which a curve's tangents spread over less than this (radians)."""
    both = np.stack([trace.heading, trace.arriving])
    so_far = np.maximum.accumulate(both.max(axis=0)) - np.minimum.accumulate(both.min(axis=0))
    return float(trace.t[np.flatnonzero(so_far < spread)[-1]])


def does_not_cross(
    column: int, angle: float, limits: str, candidates: Iterable[Remedy]
) -> DesignError:
    """The refusal of a chord of g, after a column from 0, at an angle to f's plane."""
    return DesignError(
        "f's plane does not cross the chord of g",
        place=f"between columns {column + 1} and {column + 2}",
        size=f"the angle between them is {in_degrees(angle)} degrees, and must lie between 0 and "
        f"180{limits}",
        candidates=candidates,
        excess=max(-angle, angle - np.pi) / np.pi,
    )


LARGE_ANGLES: tuple[str, ...] = ("xi_deg", "row_angle_deg", "plane_deg", "sector_deg")
"""Keys of angles that are tens of degrees: less than half a turn in radians is hardly any."""
EITHER: tuple[str, ...] = ("heading_deg",)
"""Keys of angles that are as small where g runs along y."""
UNLIKE, ABSURD = 30.0, 100.0
"""A curve this many times as large as the other may be in another unit; and draws a warning."""
UNITS = (1000.0, 100.0, 25.4, 10.0)
"""How many times larger numbers are in another unit, the likeliest first: millimetres for metres,
centimetres for metres, millimetres for inches, millimetres for centimetres."""
SMALLEST_CURVE = 0.05
"""A curve that would be so small a share of the other is in no such unit."""
SAMPLES = 65


@dataclass(frozen=True, slots=True)
class Slip:
    """What may have been meant otherwise."""

    words: str  # what is so, as a clause
    meant: tuple[Remedy, ...]  # what else may have been meant, the likeliest first: it is tried
    warning: str  # what a shell that is made of it is warned of; "" if of nothing


def forgiving(pattern: Pattern, make: Callable[..., Design], *target: Curve) -> Design:
    """Design a pattern, with f and g if it has a target, and say what looks like a slip of the pen.

    Where the family refuses, what may have been meant comes first among the candidates.
    """
    slips = [*_radians(pattern), *(_units(*target) if target else ())]
    try:
        pattern.note_all(beside=pattern.idle())
        design = make(*target, pattern)
    except DesignError as error:
        if slips:
            error.size = "; ".join(filter(None, [error.size, *(slip.words for slip in slips)]))
            error.candidates = chain(*(slip.meant for slip in slips), error.candidates)
        raise
    warnings = tuple(slip.warning for slip in slips if slip.warning)
    return replace(design, warnings=(*warnings, *design.warnings)) if warnings else design


def _radians(pattern: Pattern) -> Iterator[Slip]:
    """Angles in degrees that may have been meant in radians."""
    for key in (*LARGE_ANGLES, *EITHER):
        value: list[float] | float | str = getattr(pattern, key, "auto")
        if key not in pattern.model_fields_set or isinstance(value, str):
            continue
        angles = value if isinstance(value, list) else [value]
        if all(0 < angle < np.pi for angle in angles):
            degrees = [rounded(float(np.rad2deg(angle))) for angle in angles]
            meant: Value = degrees if isinstance(value, list) else degrees[0]
            remedy = Remedy({f"pattern.{key}": meant})
            words = f"{key} is in degrees ({value} radians are {str(remedy).partition(' = ')[2]})"
            warning = (
                f"{words}: if radians were meant, write {remedy}" if key in LARGE_ANGLES else ""
            )
            yield Slip(words, (remedy,), warning)


def _units(f: Curve, g: Curve) -> Iterator[Slip]:
    """Curves of so unlike sizes that one may be in another unit than the design."""
    sizes = {"f": _size(f), "g": _size(g)}
    small, large = sorted(sizes, key=sizes.__getitem__)
    ratio = sizes[large] / sizes[small] if sizes[small] else np.inf
    if not UNLIKE <= ratio < np.inf:
        return
    curve = f if large == "f" else g
    words = f"{large} is {plain(ratio, 2)} times as large as {small}: " + (
        f"if it is in another unit, say which (unit in [target.{large}])"
        if curve.key == "part"
        else "formulas are in the unit of [shell]"
    )
    meant = (
        Remedy({f"target.{large}.scale": curve.scale_times(1 / times)})
        for times in UNITS
        if ratio / times >= SMALLEST_CURVE
    )
    yield Slip(words, tuple(meant), words if ratio >= ABSURD else "")


def _size(curve: Curve) -> float:
    points = curve.position(np.linspace(curve.start, curve.stop, SAMPLES))
    return float(np.hypot(*np.ptp(points, axis=0)))


def refuse_stop(stop: float, limit: float, where: str) -> DesignError:
    """The error for flaps that would stop too far short of folding flat.

    Parameters
    ----------
    stop, limit
        By how much, and the least that is too much (radians).
    where
        What is so at the limit.
    """
    most, asked = tidy_degrees(limit), tidy_degrees(stop)
    return DesignError(
        "flaps cannot stop so far short of folding flat",
        keys=("panel.stop_deg",),
        size=f"they would stop {in_degrees(stop)} degrees short, and the limit is "
        f"{in_degrees(limit)}, {where}",
        candidates=(Remedy({"panel.stop_deg": value}) for value in between(0, most, asked)),
        excess=(stop - limit) / np.pi,
    )
