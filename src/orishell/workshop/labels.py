"""Words on the work: rows and columns of panels, fold angles of creases."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from orishell.document import Document
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.workshop.creases import mean_edge
from orishell.workshop.drawing import Text
from orishell.workshop.outline import signed_areas
from orishell.workshop.part import Part
from orishell.workshop.settings import Workshop

CHARACTER = 1.0
"""Width kept for a character, in heights of capitals: that of CAD programs' stroke fonts."""

FILLED = 0.6
"""Share that a label takes of the height that would just fit."""

BESIDE = 1.0
"""Distance of a crease from the middle of its label, in heights."""

WITH_PANELS = 2.5
"""Heights of a crease's label that must fit where panels are labelled too."""

USUAL = 50
"""Percentage of labels that may be smaller than the rest, which are all of one height."""

UPRIGHT = np.array([np.cos(np.deg2rad(10)), np.sin(np.deg2rad(10))])
"""Labels lie within a right angle of this direction: as on plans, steep ones are read upwards."""

_SMALLEST = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class _Labels:
    """Words (N,) at middles (N, 2), along directions (N, 2), in the layer ENGRAVE."""

    words: tuple[str, ...]
    middles: Array
    directions: Array
    heights: Array

    def of(self, chosen: Booleans) -> tuple[Text, ...]:
        angles = np.arctan2(self.directions[:, 1], self.directions[:, 0])
        rows = zip(self.words, self.middles.tolist(), self.heights, angles, chosen, strict=True)
        return tuple(
            Text("ENGRAVE", x, y, float(height), words, float(angle))
            for words, (x, y), height, angle, shown in rows
            if shown and height > 0
        )


def part_labels(document: Document, part: Part, workshop: Workshop) -> tuple[Text, ...]:
    """What is engraved on a part, in the sheet's own coordinates; never upside down."""
    texts: tuple[Text, ...] = ()
    if not len(part.panels):
        return texts
    taken = np.zeros(len(document.mesh.faces))
    if workshop.labels in ("creases", "both"):
        tall = 1.0 if workshop.labels == "creases" else WITH_PANELS
        creases, panels = _crease_labels(document, part, tall)
        texts = creases.of(panels >= 0)
        np.maximum.at(taken, panels[panels >= 0], (BESIDE + 0.5) * creases.heights[panels >= 0])
    if workshop.labels in ("panels", "both"):
        chosen = np.isin(np.arange(len(taken)), part.panels)
        texts = _panel_labels(document, taken).of(chosen) + texts
    return texts


def _panel_labels(document: Document, taken: Array) -> _Labels:
    """Row and column in the middle of every panel, along its longer direction.

    Parameters
    ----------
    taken
        Width (F,) of what other labels take along the panel's edges.
    """
    corners = _convex_panels(document)
    words = tuple(document.panel_name(panel) for panel in range(len(corners)))
    middles = _centroids(corners)
    sides = 0.5 * (corners + np.roll(corners, -1, axis=1))
    counts = np.array([len(word) for word in words])
    tried = [_readable(sides[:, k + 2] - sides[:, k]) for k in (0, 1)]
    fits = [_heights(corners, middles, along, counts, taken=taken) for along in tried]
    first = fits[0] >= fits[1]
    heights = _evened(FILLED * np.where(first, *fits), 0.25 * mean_edge(document))
    return _Labels(words, middles, np.where(first[:, None], *tried), heights)


def _crease_labels(document: Document, part: Part, tall: float) -> tuple[_Labels, Integers]:
    """The fold angle beside the middle of every crease that folds, and the panel it stands on.

    It stands above the crease, below only where the panel above belongs to another part. The
    panel is -1 for creases that are not on the part. As many heights of the label as ``tall`` says
    must fit into the panel.
    """
    flat, mesh = document.require_flat(), document.mesh
    angles = np.round(document.fold_angles_deg, 1)
    folding = np.flatnonzero(mesh.crease & np.isfinite(angles) & (angles != 0))
    words = tuple(f"{angle:+.1f}°" for angle in angles[folding])
    ends = flat[mesh.edges[folding]]
    along = _readable(ends[:, 1] - ends[:, 0])
    middles, above = ends.mean(axis=1), np.column_stack([-along[:, 1], along[:, 0]])
    panels = _convex_panels(document)
    beside = mesh.edge_faces[folding]
    side = ((_centroids(panels)[beside] - middles[:, None]) * above[:, None]).sum(axis=2)
    here = np.isin(beside, part.panels)
    chosen = np.argmax(np.where(here, 2.0, 0.0) + (side > 0), axis=1)
    rows = np.arange(len(folding))
    panel, sign = beside[rows, chosen], np.sign(side[rows, chosen])
    counts = np.array([len(word) for word in words], dtype=np.int64)
    offset = BESIDE + 0.5 * (tall - 1.0)
    heights = _heights(panels[panel], middles, along, counts, tall=tall, offset=offset * sign)
    heights = _evened(FILLED * heights, 0.1 * mean_edge(document))
    middles = middles + (BESIDE * sign * heights)[:, None] * above
    on_part = here.any(axis=1) & np.isin(folding, part.creases)
    return _Labels(words, middles, along, heights), np.where(on_part, panel, -1)


def _convex_panels(document: Document) -> Array:
    """Corners (F, 4, 2) of every panel, counter-clockwise; of one with a reflex corner a half.

    That half is the larger triangle beside the diagonal from the reflex corner, with its last
    corner twice.
    """
    corners = document.require_flat()[document.mesh.faces]
    clockwise = signed_areas(corners) < 0
    corners = np.where(clockwise[:, None, None], corners[:, ::-1], corners)
    before, after = corners - np.roll(corners, 1, axis=1), np.roll(corners, -1, axis=1) - corners
    turn = before[..., 0] * after[..., 1] - before[..., 1] * after[..., 0]
    reflex = np.flatnonzero((turn < 0).any(axis=1))
    first = np.argmin(turn[reflex], axis=1)
    numbers = (first[:, None] + np.array([[0, 1, 2, 2]])) % 4
    others = (first[:, None] + np.array([[0, 2, 3, 3]])) % 4
    one = np.take_along_axis(corners[reflex], numbers[..., None], axis=1)
    two = np.take_along_axis(corners[reflex], others[..., None], axis=1)
    larger = signed_areas(one) >= signed_areas(two)
    corners[reflex] = np.where(larger[:, None, None], one, two)
    return corners


def _centroids(corners: Array) -> Array:
    """Centroids (N, 2) of quadrilaterals (N, 4, 2)."""
    one, two = signed_areas(corners[:, [0, 1, 2]]), signed_areas(corners[:, [0, 2, 3]])
    total = (one[:, None] * corners[:, [0, 1, 2]].mean(axis=1)) + (
        two[:, None] * corners[:, [0, 2, 3]].mean(axis=1)
    )
    return np.asarray(total / (one + two)[:, None])


def _readable(vectors: Array) -> Array:
    """Unit vectors (N, 2) along those given, from -80 to 100 degrees: steep ones go upwards."""
    unit = vectors / np.hypot(*vectors.T)[:, None]
    return np.asarray(np.where((unit @ UPRIGHT < 0)[:, None], -unit, unit))


def _heights(
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

    Parameters
    ----------
    corners
        Corners (N, 4, 2), counter-clockwise.
    middles, along
        Points (N, 2) and directions (N, 2) of the text.
    counts
        Number of characters (N,).
    offset
        How far the text's middle lies above the point, in heights.
    taken
        Width of what is kept free along the sides, at most most of the way to the nearest.
    tall
        Height of what is to fit, in heights of the text.
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
    binding = needed > _SMALLEST
    heights = np.where(binding, free / np.where(binding, needed, 1.0), np.inf).min(axis=1)
    return np.asarray(np.maximum(heights, 0.0))


def _evened(heights: Array, most: float) -> Array:
    """Heights (N,) cut down to one that most labels reach, and to ``most``."""
    if not len(heights):
        return heights
    return np.minimum(heights, min(float(np.percentile(heights, USUAL)), most))
