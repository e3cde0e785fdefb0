"""Words fitted into convex outlines: where they stand, which way, and how high."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.record import record
from orishell.motion.quads import signed_areas
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.workshop.palettes import Text

CHARACTER = 1.0
"""Width kept for a character, in heights of capitals: that of CAD programs' stroke fonts."""

FILLED = 0.6
"""Share that a label takes of the height that would just fit."""

BESIDE = 1.0
"""Distance of a crease from the middle of its label, in heights."""

USUAL = 50
"""Percentage of labels that may be smaller than the rest, which are all of one height."""

UPRIGHT = np.array([np.cos(np.deg2rad(10)), np.sin(np.deg2rad(10))])
"""Labels lie within a right angle of this direction: as on plans, steep ones are read upwards."""

NOT_BOUND = 1e-9


@record
class Labels:
    """Words at middles (N, 2), along directions (N, 2), of heights (N,), in the layer ENGRAVE."""

    words: tuple[str, ...]
    middles: Array
    directions: Array
    heights: Array

    def of(self, chosen: Booleans | None = None) -> tuple[Text, ...]:
        """Those that are chosen (N,), or all, but for words without a height."""
        chosen = np.ones(len(self.words), np.bool_) if chosen is None else chosen
        angles = np.arctan2(self.directions[:, 1], self.directions[:, 0])
        rows = zip(self.words, self.middles.tolist(), self.heights, angles, chosen, strict=True)
        return tuple(
            Text("ENGRAVE", x, y, float(height), words, float(angle))
            for words, (x, y), height, angle, shown in rows
            if shown and height > 0
        )

    def at(self, places: Integers) -> Labels:
        """Those at some places (M,)."""
        words = tuple(self.words[place] for place in places.tolist())
        return Labels(words, self.middles[places], self.directions[places], self.heights[places])

    def meet(self, others: Labels) -> Booleans:
        """Which of them (N,) meet the one of the others in the same place."""
        x, y = self.directions, np.column_stack([-self.directions[:, 1], self.directions[:, 0]])
        halves = [
            0.5
            * each.heights[:, None]
            * np.reshape([(CHARACTER * len(word), 1.0) for word in each.words], (-1, 2))
            for each in (self, others)
        ]
        away = others.middles - self.middles
        turn = np.abs(np.stack([(x * others.directions).sum(1), (y * others.directions).sum(1)]))
        meets = np.ones(len(self.words), np.bool_)
        for along, (cosine, sine), own in (
            (x, turn, halves[0][:, 0]),
            (y, turn[::-1], halves[0][:, 1]),
        ):
            reach = own + cosine * halves[1][:, 0] + sine * halves[1][:, 1]
            meets &= np.abs((along * away).sum(axis=1)) < reach
        return meets


def label_middles(
    words: tuple[str, ...],
    outlines: Array,
    directions: tuple[Array, Array],
    most: float,
    taken: Sequence[tuple[Array, Array | float]] = (),
) -> Labels:
    """Words in the middle of outlines, along that of two directions in which they are higher.

    outlines: Corners (N, K, 2), convex and counter-clockwise.
    directions: Unit vectors (N, 2).
    taken: Outlines that words must fit, each with the width that is kept free along its sides; none
        for those given.
    """
    middles = centroids(outlines)
    counts = np.array([len(word) for word in words], dtype=np.int64)
    fits = [
        np.min(
            [
                text_heights(around, middles, along, counts, taken=width)
                for around, width in taken or [(outlines, 0.0)]
            ],
            axis=0,
        )
        for along in directions
    ]
    first = fits[0] >= fits[1]
    heights = evened(FILLED * np.where(first, *fits), most)
    return Labels(words, middles, np.where(first[:, None], *directions), heights)


def label_edges(
    words: tuple[str, ...],
    outlines: Array,
    ends: Array,
    *,
    tall: float,
    most: float,
    share: float = 0.5,
    usual: float = USUAL,
) -> Labels:
    """Words along edges, inside outlines; their height is 0 where there is no room for them.

    outlines: Corners (N, K, 2) of what they must fit, convex and counter-clockwise.
    ends: Ends (N, 2, 2) of the edges.
    tall: Height of what is to fit, in heights of the text.
    share: Where they stand on their edge, from its first end.
    usual: As :data:`USUAL`; 100 for words that are each as high as there is room.
    """
    along = readable(ends[:, 1] - ends[:, 0])
    middles = (1 - share) * ends[:, 0] + share * ends[:, 1]
    above = np.column_stack([-along[:, 1], along[:, 0]])
    sign = np.sign(((centroids(outlines) - middles) * above).sum(axis=1))
    counts = np.array([len(word) for word in words], dtype=np.int64)
    offset = (BESIDE + 0.5 * (tall - 1.0)) * sign
    heights = text_heights(outlines, middles, along, counts, tall=tall, offset=offset)
    heights = evened(FILLED * heights, most, usual)
    return Labels(words, middles + (BESIDE * sign * heights)[:, None] * above, along, heights)


def ways_across(corners: Array) -> tuple[Array, Array]:
    """Both readable directions (N, 2) across quadrilaterals (N, 4, 2)."""
    sides = 0.5 * (corners + np.roll(corners, -1, axis=1))
    return readable(sides[:, 2] - sides[:, 0]), readable(sides[:, 3] - sides[:, 1])


def centroids(corners: Array) -> Array:
    """Centroids (N, 2) of convex polygons (N, K, 2)."""
    count = corners.shape[1]
    fan = np.stack([np.zeros(count - 2, int), np.arange(1, count - 1), np.arange(2, count)], -1)
    areas = signed_areas(corners[:, fan])[..., None]
    return np.asarray((areas * corners[:, fan].mean(axis=2)).sum(axis=1) / areas.sum(axis=1))


def readable(vectors: Array) -> Array:
    """Unit vectors (N, 2) along those given, from -80 to 100 degrees: steep ones go upwards."""
    unit = vectors / np.hypot(*vectors.T)[:, None]
    return np.asarray(np.where((unit @ UPRIGHT < 0)[:, None], -unit, unit))


def text_heights(
    corners: Array,
    middles: Array,
    along: Array,
    counts: Integers,
    *,
    offset: Array | float = 0.0,
    taken: Array | float = 0.0,
    tall: float = 1.0,
) -> Array:
    """Height (N,) of the highest text that lies within each convex panel.

    corners: Corners (N, K, 2), counter-clockwise.
    middles, along: Points (N, 2) and directions (N, 2) of texts with so many characters (N,).
    offset: How far the text's middle lies above the point, in heights.
    taken: Width of what is kept free along the sides, at most most of the way to the nearest.
    tall: Height of what is to fit, in heights of the text.
    """
    sides = np.roll(corners, -1, axis=1) - corners
    lengths = np.hypot(sides[..., 0], sides[..., 1])
    inward = np.stack([-sides[..., 1], sides[..., 0]], axis=-1)
    inward /= np.where(lengths > 0, lengths, 1.0)[..., None]
    free = ((middles[:, None] - corners) * inward).sum(axis=2)
    nearest = np.where(lengths > 0, free, np.inf).min(axis=1)
    free -= np.minimum(taken, 0.8 * np.maximum(nearest, 0.0))[:, None]
    above = np.column_stack([-along[:, 1], along[:, 0]])
    parallel = (inward * along[:, None]).sum(axis=2)
    square = (inward * above[:, None]).sum(axis=2)
    needed = 0.5 * CHARACTER * counts[:, None] * np.abs(parallel)
    needed += 0.5 * tall * np.abs(square)
    needed -= np.reshape(offset, (-1, 1)) * square
    binding = needed > NOT_BOUND
    heights = np.where(binding, free / np.where(binding, needed, 1.0), np.inf).min(axis=1)
    return np.asarray(np.maximum(heights, 0.0))


def evened(heights: Array, most: float, usual: float = USUAL) -> Array:
    """Heights (N,) cut down to one that most labels reach, and to ``most``."""
    if not len(heights):
        return heights
    return np.minimum(heights, min(float(np.percentile(heights, usual)), most))
