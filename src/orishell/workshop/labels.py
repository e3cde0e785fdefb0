"""Words on the work: rows and columns of panels, fold angles of creases."""

from __future__ import annotations

import numpy as np

from orishell.document import Document
from orishell.motion.quads import signed_areas
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.boards import board_labels
from orishell.workshop.creases import mean_edge
from orishell.workshop.cut_parts import CutPart
from orishell.workshop.drawing import Text
from orishell.workshop.fitted_words import (
    BESIDE,
    Labels,
    centroids,
    label_edges,
    label_middles,
    readable,
    ways_across,
)
from orishell.workshop.settings import Workshop

WITH_PANELS = 2.5
"""Heights of a crease's label that must fit where panels are labelled too."""


def part_labels(document: Document, part: CutPart, workshop: Workshop) -> tuple[Text, ...]:
    """What is engraved on a part, in the sheet's own coordinates; never upside down.

    Where boards are glued on, their part numbers take the place of rows and columns.
    """
    texts: tuple[Text, ...] = ()
    if not len(part.panels):
        return texts
    taken = np.zeros(len(document.mesh.faces))
    glued = document.boards is not None and bool(document.boards.sides.any())
    if workshop.labels in ("creases", "both"):
        tall = 1.0 if workshop.labels == "creases" and not glued else WITH_PANELS
        creases, panels = _crease_labels(document, part, tall)
        texts = creases.of(panels >= 0)
        np.maximum.at(taken, panels[panels >= 0], (BESIDE + 0.5) * creases.heights[panels >= 0])
    if glued:
        texts = board_labels(document, 1, part.panels, taken) + texts
    elif workshop.labels in ("panels", "both"):
        chosen = np.isin(np.arange(len(taken)), part.panels)
        texts = _panel_labels(document, taken).of(chosen) + texts
    return texts


def panel_labels(document: Document, taken: Array) -> tuple[Text, ...]:
    """Row and column in the middle of every panel, along its longer direction.

    Parameters
    ----------
    taken
        Width (F,) of what other labels take along the panel's edges.
    """
    return _panel_labels(document, taken).of(np.ones(len(taken), np.bool_))


def _panel_labels(document: Document, taken: Array) -> Labels:
    corners = _convex_panels(document)
    words = tuple(document.panel_name(panel) for panel in range(len(corners)))
    most = 0.25 * mean_edge(document)
    return label_middles(words, corners, ways_across(corners), most, [(corners, taken)])


def _crease_labels(document: Document, part: CutPart, tall: float) -> tuple[Labels, Integers]:
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
    along = readable(ends[:, 1] - ends[:, 0])
    middles, above = ends.mean(axis=1), np.column_stack([-along[:, 1], along[:, 0]])
    panels = _convex_panels(document)
    beside = mesh.edge_faces[folding]
    side = ((centroids(panels)[beside] - middles[:, None]) * above[:, None]).sum(axis=2)
    here = np.isin(beside, part.panels)
    chosen = np.argmax(np.where(here, 2.0, 0.0) + (side > 0), axis=1)
    rows = np.arange(len(folding))
    panel = beside[rows, chosen]
    labels = label_edges(words, panels[panel], ends, tall=tall, most=0.1 * mean_edge(document))
    on_part = here.any(axis=1) & np.isin(folding, part.creases)
    return labels, np.where(on_part, panel, -1)


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
