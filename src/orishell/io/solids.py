"""The boards of a document as solids: in a state, or lying flat beside each other."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.record import record
from orishell.document import Document, DocumentState
from orishell.motion.boards import Boards
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.clipped import lying_beside


@record
class Solids:
    """Boards of the sheet, or of one strip of flaps that is clipped on, where they are.

    Parameters
    ----------
    names
        What they are called, as in "3,12 top".
    boards
        The boards (B).
    corners
        Corners (B, H, K, 3) of their outlines, in the document's frame and unit.
    """

    names: tuple[str, ...]
    boards: Boards
    corners: Array


@record
class SolidMesh:
    """Boards as one mesh of triangles, closed around each of them, in a document's frame and unit.

    Parameters
    ----------
    names
        What the boards are called, as in "3,12 top".
    sides
        The face (B,) that each lies on: 1 top, -1 bottom, 0 for a panel in one piece.
    vertices
        Vertices (N, 3), those of a board one after the other.
    triangles
        Numbers (T, 3) of their corners, counter-clockwise seen from outside.
    first_vertex, first_triangle
        Numbers (B + 1,) with which the boards begin, and the last one ends.
    """

    names: tuple[str, ...]
    sides: Integers
    vertices: Array
    triangles: Integers
    first_vertex: Integers
    first_triangle: Integers

    def each(self) -> Iterator[tuple[str, Array, Integers]]:
        """Name, vertices and triangles of every board by itself, numbered from 0."""
        points, triangles = self.first_vertex.tolist(), self.first_triangle.tolist()
        for board, name in enumerate(self.names):
            first = points[board]
            yield (
                name,
                self.vertices[first : points[board + 1]],
                self.triangles[triangles[board] : triangles[board + 1]] - first,
            )


def solids_in(document: Document, which: int | str) -> tuple[Solids, ...]:
    """The boards in a state; at the target, those that are clipped on come after the sheet's.

    Parameters
    ----------
    which
        The state's number or name.

    Raises
    ------
    InputError
        If panels have no thickness, or there is no such state.
    """
    clipped = (_solids(flap, flap.shell) for flap in document.clipped_at(which))
    return (_solids(document, document.state(which)), *clipped)


def solids_lying(document: Document) -> tuple[Solids, ...]:
    """The boards as they are cut: the flat sheet, z up, and what is clipped on lies beside it.

    Raises
    ------
    InputError
        If panels have no thickness.
    """
    sheet = _solids(document, _lying(document.require_flat()))
    beside = zip(document.clipped, lying_beside(document), strict=True)
    return (sheet, *(_solids(flap, _lying(flat)) for flap, flat in beside))


def mesh_of(solids: tuple[Solids, ...]) -> SolidMesh:
    """All boards as one mesh."""
    surfaces = [each.boards.surfaces(each.corners) for each in solids]
    starts = np.cumsum([0, *(len(each.vertices) for each in surfaces)])
    joined = np.concatenate(
        [each.triangles + start for each, start in zip(surfaces, starts, strict=False)]
    )
    counts = [np.unique(each.boards, return_counts=True)[1] for each in surfaces]
    first = np.concatenate([[0], np.cumsum(np.concatenate(counts))])
    # Vertices of a board are one after the other: its least number is where they begin.
    begins = np.minimum.reduceat(joined.min(axis=1), first[:-1])
    return SolidMesh(
        names=sum((each.names for each in solids), ()),
        sides=np.concatenate([each.boards.sides for each in solids]),
        vertices=np.concatenate([each.vertices for each in surfaces]),
        triangles=joined,
        first_vertex=np.append(begins, starts[-1]),
        first_triangle=first,
    )


def _solids(document: Document, state: DocumentState) -> Solids:
    corners = document.boards_in(state)
    assert document.boards is not None
    names = tuple(document.board_name(board) for board in range(len(document.boards)))
    return Solids(names, document.boards, corners)


def _lying(flat: Array) -> DocumentState:
    return DocumentState(np.column_stack([flat, np.zeros(len(flat))]))
