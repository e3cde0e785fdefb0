"""The sheet and the boards that are clipped on at its target, as pieces of one flat pattern."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from orishell.document import Document
from orishell.motion.boards import Boards
from orishell.motion.mesh import build_mesh
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.creases import mean_edge
from orishell.workshop.cut_parts import find_outlines

GAP = 0.25
"""Boards are moved by multiples of this share of the mean edge of the sheet's panels."""
CLOSE = 0.5
"""They stop where the gap around them is at least this share of such a step."""


def with_clipped(document: Document) -> Document:
    """The flat sheet with what is clipped on beside it: pieces that do not hang together.

    Their vertices, edges, panels and boards come after the sheet's. Each piece lies beside the edge
    that it is clipped on, with a gap. A document with nothing clipped on is returned as it is.

    Raises
    ------
    InputError
        If there is no flat sheet.
    """
    if not document.clipped:
        return document
    pieces = (document, *document.clipped)
    flats = [document.require_flat(), *lying_beside(document)]
    first = np.cumsum([0, *map(len, flats)])

    def numbered(arrays: Iterable[Integers]) -> Integers:
        return np.concatenate([array + k for array, k in zip(arrays, first, strict=False)])

    return replace(
        document,
        mesh=build_mesh(
            numbered(piece.mesh.faces for piece in pieces),
            int(first[-1]),
            numbered(piece.mesh.edges for piece in pieces),
            np.concatenate([~piece.mesh.crease for piece in pieces]),
        ),
        assignment=sum((piece.assignment for piece in pieces), ()),
        flat=np.concatenate(flats),
        fold_angles_deg=np.concatenate([piece.fold_angles_deg for piece in pieces]),
        states=(),
        grid_shape=None,
        named={},
        names=tuple(p.panel_name(panel) for p in pieces for panel in range(len(p.mesh.faces))),
        boards=_all_boards(pieces, flats),
        clipped=(),
    )


def _all_boards(pieces: Sequence[Document], flats: Sequence[Array]) -> Boards | None:
    """The boards of all pieces, where these lie (V, 2) now; None if panels have no thickness."""
    made, first = [], 0
    corners = max((p.boards.outlines.shape[2] for p in pieces if p.boards is not None), default=0)
    for piece, flat in zip(pieces, flats, strict=True):
        if piece.boards is not None:
            shift = np.append(flat[0] - piece.require_flat()[0], 0.0)
            own = piece.boards.outlines + shift
            spare = ((0, 0), (0, 0), (0, corners - own.shape[2]), (0, 0))
            outlines = np.pad(own, spare, mode="edge")  # corners that coincide with the last
            made.append(Boards(piece.boards.panels + first, piece.boards.sides, outlines))
        first += len(piece.mesh.faces)
    if not made:
        return None
    return Boards(
        np.concatenate([each.panels for each in made]),
        np.concatenate([each.sides for each in made]),
        np.concatenate([each.outlines for each in made]),
    )


def lying_beside(document: Document) -> Iterator[Array]:
    """The flat vertices (V, 2) of each board, moved outwards until it has a gap around it."""
    from shapely import Polygon
    from shapely.affinity import translate

    def rim(piece: Document) -> Polygon:
        flat = piece.require_flat()
        return Polygon(flat[find_outlines(piece.mesh.faces, flat)[0]])

    placed, gap = [rim(document)], GAP * mean_edge(document)
    middle = np.array(placed[0].centroid.coords[0])
    for board in document.clipped:
        own = rim(board)
        away = np.array(own.centroid.coords[0]) - middle
        step = gap * away / np.hypot(*away)
        count = 1
        while min(map(translate(own, *(count * step)).distance, placed)) < CLOSE * gap:
            count += 1
        placed.append(translate(own, *(count * step)))
        yield board.require_flat() + count * step
