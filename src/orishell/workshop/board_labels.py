"""Part numbers on boards and where they are glued on."""

from __future__ import annotations

import numpy as np

from orishell.document import Document
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.board_outlines import MIRRORED, Side, seen_from_outside
from orishell.workshop.creases import mean_edge
from orishell.workshop.drawing import Text
from orishell.workshop.fitted_words import label_middles, ways_across

LARGEST = 0.25
"""Height of a part number at most, as a share of the mean edge of panels."""


def board_labels(
    document: Document,
    side: Side,
    panels: Integers | None = None,
    taken: Array | float = 0.0,
) -> tuple[Text, ...]:
    """Part numbers in the middle of boards, or of the places where they are glued on.

    Parameters
    ----------
    side
        Of the boards; those at the bottom are seen from below, mirrored about the y axis.
    panels
        Only boards on these panels; None for all.
    taken
        Width (F,) of what other labels take along the panels' edges.
    """
    boards = seen_from_outside(document, side)
    corners = document.require_flat()[document.mesh.faces[boards.panels]]
    if side < 0:
        corners = corners[:, ::-1] * MIRRORED
    beside = np.broadcast_to(taken, len(document.mesh.faces))[boards.panels]
    labels = label_middles(
        boards.names,
        boards.outlines,
        ways_across(corners),
        LARGEST * mean_edge(document),
        [(boards.outlines, 0.0), (corners, beside)],
    )
    everywhere = np.ones(len(boards.names), np.bool_)
    return labels.of(everywhere if panels is None else np.isin(boards.panels, panels))
