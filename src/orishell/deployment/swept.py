"""The ground that a shell needs while it moves, and its height: nothing of it is ever outside.

The outline is the convex hull of the shell's plans in some states, with a margin. Between states at
drives a and b, apart by h, let e be the vector from the middle of the feet to a corner, and W the
turn from the frame of the mechanism to the ground. With straight lines between their values,

    abs(e - e_line) <= h^2/8 max abs(e''),          abs(W - W_line) <= h^2/8 max abs(W''),

and W_line e_line leaves the straight line between the corner's two places on the ground by no more
than abs(W_b - W_a) abs(e_b - e_a)/4. That line lies in the hull. W depends on the direction u of
the line between the feet alone; with its slope, of the cosine c, and its turning v = abs(u'),

    abs(W'') <= 2 abs(u'')/c + 5 v^2/c^2.

Where feet nearly meet that is too much, and the turn within the range is taken: if u leaves its
values at both ends by an angle t at most, a corner moves by t abs(e)/c. Ranges are parted until the
margin takes a small share of the area, or what moves in them is well inside.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.record import record
from orishell.deployment.occupied import Occupied
from orishell.deployment.plans import corners_of, hull_of, outermost, polygon
from orishell.deployment.standing import Place, Standing
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.equals import first_largest, first_smallest

FIRST = 24
"""Ranges that are begun with."""
SHARE = 0.004
"""The margin takes about this share of the area."""
PARTS = 4
"""A range is parted into so many at once, at most."""
ROUNDS, MOST_CORNERS = 24, 20_000_000
"""So often are ranges parted, and no more than so many corners are placed, of all states."""
NARROWEST_RANGE = 2.0**-30
"""A range that is a smaller part than this of the way is not parted."""
LAST = 64 * NARROWEST_RANGE
"""In so much of the way, at the very end of a motion, accelerations may grow beyond all bounds:
there the ends of ranges that are not parted further are inside. Elsewhere it is not known then."""
NUMBERS = 2_000_000
"""Coordinates that are held at once: memory grows with it."""


@record
class Sweep:
    """What a shell moves through on the ground, seen from the middle of its feet at the target."""

    outline: Array  # convex, (K, 2), counter-clockwise, margin included
    margin: float  # what was added for the way between two states (length)
    states: int  # how many states were made
    height: float  # the greatest of a state from lowest to highest corner, margin included
    highest_at: float  # where it is as high (radians)
    # how far it gets below the middle of its feet, margin included where it does (length)
    below: float
    lowest_at: float  # where it does (radians)


@record
class _Looked:
    """Ranges of the drive (S,) as they were looked at."""

    start: Array
    stop: Array
    margin: Array  # how far anything leaves the hull of both ends in between
    hulls: list[Array]  # of the plans at both ends, (K, 2) each
    # at the starts and stops (S, 2), heights of states, and of their lowest corners over the feet
    high: Array
    low: Array

    def only(self, which: Booleans) -> _Looked:
        hulls = [hull for hull, chosen in zip(self.hulls, which, strict=True) if chosen]
        return _Looked(
            self.start[which],
            self.stop[which],
            self.margin[which],
            hulls,
            self.high[which],
            self.low[which],
        )


def find_sweep(
    standing: Standing, occupied: Occupied, end: float, beside: Array | None = None
) -> Sweep | None:
    """What a shell moves through between a drive, flat or packed, and its target.

    Parameters
    ----------
    end
        The drive that it is opened or folded up from (radians).
    beside
        Points (K, 3) of what it carries at the target only, as flaps that are clipped on there.

    Returns
    -------
    Sweep or None
        None if that takes too many states, as where panels turn over within a small part of it, or
        if accelerations have no bound on the way.
    """
    target = standing.mechanism.target_drive
    hull, *heights = at_target(standing, occupied, beside)
    cuts = np.linspace(min(end, target), max(end, target), FIRST + 1)
    start, stop = cuts[:-1], cuts[1:]
    made, corners = 1, occupied.count
    shape = polygon(hull)
    margin = SHARE * shape.area / shape.length
    states = np.array([[target, *heights]])
    for _ in range(ROUNDS):
        if (made + len(start)) * corners > MOST_CORNERS:
            return None
        looked = _look(standing, occupied, start, stop)
        made += 1 + len(start)
        hull = hull_of(np.concatenate([hull, *looked.hulls]))
        ends = (
            np.stack([at, looked.high[:, side], looked.low[:, side]], axis=1)
            for side, at in enumerate((looked.start, looked.stop))
        )
        states = np.concatenate([states, *ends])
        left = ~_within(looked, hull, margin, float(states[:, 1].max()), float(states[:, 2].min()))
        way = abs(end - target)
        small = stop - start <= NARROWEST_RANGE * way
        if (left & small & (np.maximum(abs(start - end), abs(stop - end)) > LAST * way)).any():
            return None
        left &= ~small
        if not left.any():
            return _swept(states, hull, margin, occupied.beyond, made)
        start, stop = _parted(looked.only(left), margin)
    return None


def _swept(states: Array, hull: Array, margin: float, beyond: float, made: int) -> Sweep:
    """What states (S, 3), each its drive and heights, and their hull say; boards reach beyond."""
    wide = margin + beyond
    buffered = polygon(hull).buffer(wide, join_style="mitre", mitre_limit=2.0)
    drives, high, low = states.T
    below = -float(low.min())
    return Sweep(
        outline=corners_of(buffered),
        margin=wide,
        states=made,
        height=float(high.max()) + 2 * wide,
        highest_at=float(drives[first_largest(high)]),
        below=below + wide if below > 0 else 0.0,
        lowest_at=float(drives[first_smallest(low, size=float(high.max() - low.min()))]),
    )


def at_target(
    standing: Standing, occupied: Occupied, beside: Array | None
) -> tuple[Array, float, float]:
    """Hull (K, 2) of the plan at the target, its height, and that of its lowest corner."""
    drive = np.array([standing.mechanism.target_drive])
    points = occupied.at(drive)
    if beside is not None:
        points = np.concatenate([points, beside[None]], axis=1)
    seen = standing.place(drive).seen(points)[0]
    height = seen[:, 2]
    return hull_of(outermost(seen[None, :, :2])[0]), float(np.ptp(height)), float(height.min())


def _look(standing: Standing, occupied: Occupied, start: Array, stop: Array) -> _Looked:
    """Look at ranges (S,): where the shell is at both ends, and how far it leaves that between."""
    found = list(_looked(standing, occupied, start, stop))
    return _Looked(
        start,
        stop,
        np.concatenate([each.margin for each in found]),
        [hull for each in found for hull in each.hulls],
        np.concatenate([each.high for each in found]),
        np.concatenate([each.low for each in found]),
    )


def _looked(standing: Standing, occupied: Occupied, start: Array, stop: Array) -> Iterator[_Looked]:
    """What is seen in ranges (S,), some of them at a time."""
    batch = max(1, NUMBERS // (3 * occupied.count) - 1)
    for part in (slice(k, k + batch) for k in range(0, len(start), batch)):
        drives, numbers = np.unique(np.concatenate([start[part], stop[part]]), return_inverse=True)
        ends = np.split(numbers, 2)
        points, place = occupied.at(drives), standing.place(drives)
        seen = place.seen(points)
        moved = [_largest(points[a] - points[b]) for a, b in zip(*ends, strict=True)]
        hulls = [hull_of(each) for each in outermost(seen[..., :2])]
        high, low = np.ptp(seen[..., 2], axis=1), seen[..., 2].min(axis=1)
        margin = _margin(
            standing,
            (place, ends),
            occupied.accelerations(start[part], stop[part]),
            (start[part], stop[part]),
            (np.array([_largest(each) for each in seen]), np.array(moved)),
        )
        yield _Looked(
            start[part],
            stop[part],
            margin,
            [np.concatenate([hulls[a], hulls[b]]) for a, b in zip(*ends, strict=True)],
            np.stack([high[each] for each in ends], axis=1),
            np.stack([low[each] for each in ends], axis=1),
        )


def _margin(
    standing: Standing,
    states: tuple[Place, list[Integers]],
    acceleration: Array,
    ranges: tuple[Array, Array],
    sizes: tuple[Array, Array],
) -> Array:
    """How far corners leave the straight lines between their places at the ends of ranges (S,).

    ``states`` are the places of the ground, and which of them is at the starts and the stops;
    ``sizes`` are how far corners are from the middle there, and how far they move in the ranges.
    """
    place, (first, last) = states
    step = ranges[1] - ranges[0]
    off = step**2 / 8 * acceleration
    reach = np.maximum(sizes[0][first], sizes[0][last]) + off
    # Corners and middle move by so much at most, and so does the vector between them.
    middle = lengths(place.middle[last] - place.middle[first])
    moved = sizes[1] + middle
    turning = standing.turning(place.along[first], place.along[last], ranges)
    turned = place.axes[last] - place.axes[first]
    bent = np.sqrt((turned**2).sum(axis=(-2, -1)))
    return np.asarray(off + reach * np.minimum(turning[0], turning[1] + bent * moved / reach / 4))


def _within(looked: _Looked, hull: Array, margin: float, high: float, low: float) -> Booleans:
    """In which ranges (S,) nothing leaves the hull, or the heights, by more than the margin."""
    over = looked.margin - margin
    sides = np.roll(hull, -1, axis=0) - hull
    outwards = np.stack([sides[:, 1], -sides[:, 0]], axis=-1)
    outwards /= np.hypot(*sides.T)[:, None]
    limit = (outwards * hull).sum(axis=1)
    out = np.array([(each @ outwards.T - limit).max() for each in looked.hulls])
    # Heights are between two corners, each of which may leave its straight line.
    rises, sinks = 0.5 * (looked.high.max(axis=1) - high), low - looked.low.min(axis=1)
    leaves = np.maximum(np.maximum(out, rises), sinks)
    return np.asarray((over <= 0) | (leaves <= -over))


def _parted(looked: _Looked, margin: float) -> tuple[Array, Array]:
    """Starts and stops of the parts of ranges, as many as the margin of each asks for."""
    parts = np.where(np.isfinite(looked.margin), looked.margin / margin, np.inf)
    counts = np.clip(np.ceil(np.sqrt(parts)), 2, PARTS).astype(np.int64)
    cuts = [
        np.linspace(start, stop, count + 1)
        for start, stop, count in zip(looked.start, looked.stop, counts, strict=True)
    ]
    return np.concatenate([cut[:-1] for cut in cuts]), np.concatenate([cut[1:] for cut in cuts])


def _largest(vectors: Array) -> float:
    """The greatest length of vectors (N, 3)."""
    return float(lengths(vectors).max())
