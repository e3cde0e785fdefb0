"""Rigid panels and boards as formats need them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain
from typing import Final

import numpy as np

from orishell.conventions.record import record
from orishell.document import DocumentState, Part
from orishell.motion.boards import Boards
from orishell.motion.quads import ALIKE, reflex_corners, unit_normals
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.assembly import parts_lying

TRIANGLES: Final[Integers] = np.array([[[0, 1, 2], [0, 2, 3]], [[1, 2, 3], [1, 3, 0]]])
"""Corners of a panel's two triangles (2, 2, 3), which go round as the panel does: split from
corner 0 to corner 2, or from corner 1 to corner 3."""
TRIANGLES.flags.writeable = False


def y_up(points: Array) -> Array:
    """Points (..., 3) turned about the x axis so that z comes to lie on y; without -0.0."""
    return np.asarray(points[..., [0, 2, 1]] * [1.0, 1.0, -1.0] + 0.0)


def find_splits(corners: Array) -> Integers:
    """The diagonal (F,) that splits each panel (F, 4, 3): 1 where the first runs outside, else 0.

    All panels are split from corner 0 to corner 2, except those with a corner 1 or 3 that points
    into the panel: there that diagonal runs outside, and the other one inside.
    """
    return np.asarray(reflex_corners(corners)[:, [1, 3]].any(axis=1), dtype=np.int64)


def split_panels(corners: Array) -> Array:
    """The triangles (2F, 3, 3) of panels (F, 4, 3), the two of a panel one after the other."""
    picked = TRIANGLES[find_splits(corners)].reshape(len(corners), 6, 1)
    return np.asarray(np.take_along_axis(corners, picked, axis=1).reshape(-1, 3, 3))


def find_frames(corners: Array, along: Integers) -> tuple[Array, Array]:
    """Origins (F, 3) and axes (F, 3, 3) of frames fixed in panels (F, 4, 3), as they move.

    Origins are the means of the corners. Axes are columns: z is the panel's normal, and x follows
    the diagonal from the corner ``along`` (F,), the same in all states, as
    :func:`~orishell.motion.quads.longer_diagonals` finds it. A panel without an area has any z
    square to its x axis.
    """
    panels = np.arange(len(corners))
    x = _normalised(corners[panels, along + 2] - corners[panels, along], 0)
    z = unit_normals(corners)
    z = _normalised(z - (x * z).sum(axis=1, keepdims=True) * x, (np.argmax(abs(x), axis=1) + 1) % 3)
    z = _normalised(z - (x * z).sum(axis=1, keepdims=True) * x, 0)
    return corners.mean(axis=1), np.stack([x, np.cross(z, x), z], axis=-1)


def quaternions(axes: Array) -> Array:
    """Unit quaternions (F, 4; x, y, z, w) of rotations (F, 3, 3), largest component positive.

    Of components that are alike but for rounding that is the first.

    Four times the products of a quaternion's components are a symmetric matrix made of sums and
    differences of the rotation's entries. The row with the largest diagonal is the quaternion
    but for its length, and no digits are lost in it.
    """
    diagonal = np.diagonal(axes, axis1=1, axis2=2)
    trace = diagonal.sum(axis=1)
    products = np.empty((len(axes), 4, 4))
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        products[:, i, i] = 1 + 2 * diagonal[:, i] - trace
        products[:, i, j] = products[:, j, i] = axes[:, i, j] + axes[:, j, i]
        products[:, i, 3] = products[:, 3, i] = axes[:, k, j] - axes[:, j, k]
    products[:, 3, 3] = 1 + trace
    squares = np.diagonal(products, axis1=1, axis2=2)
    largest = np.argmax(squares > squares.max(axis=1, keepdims=True) - ALIKE, axis=1)
    row = products[np.arange(len(axes)), largest]
    return np.asarray(row / np.linalg.norm(row, axis=1, keepdims=True))


def _normalised(vectors: Array, otherwise: Integers | int) -> Array:
    """Unit vectors (F, 3); where there is no direction, that of the axis of this number (F,)."""
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    axis = np.eye(3)[np.broadcast_to(otherwise, len(vectors))]
    return np.where(length > 0, vectors / np.where(length > 0, length, 1.0), axis)


@record
class Solids:
    """Boards of a part of a shell, where they are."""

    names: tuple[str, ...]  # What they are called, as in "3,12 top"
    boards: Boards  # The boards (B)
    corners: Array  # Corners (B, H, K, 3) of their outlines, in the document's frame and unit
    drilled: Integers  # The board (N,) that each hole goes through
    axes: Array  # Ends (N, 2, 3) of holes on both faces of it
    diameters: Array  # Of holes (N,)


@record
class SolidMesh:
    """Boards as one mesh, closed around each of them, in a document's frame and unit."""

    names: tuple[str, ...]  # as in "3,12 top"
    sides: Integers  # the face (B,) that each lies on, as in Boards
    vertices: Array  # vertices (N, 3), those of a board one after the other
    triangles: Integers  # their corners (T, 3), counter-clockwise seen from outside
    # numbers (B + 1,) with which the boards begin, and the last one ends
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


def solids_in(document: Part, which: int | str) -> tuple[Solids, ...]:
    """The boards of all parts that are there in a state, the sheet's first."""
    return tuple(_solids(part, state) for part, state in document.parts_in(which))


def solids_lying(document: Part) -> tuple[Solids, ...]:
    """The boards as they are cut: the flat sheet, z up, and all other parts lie beside it."""
    each = zip(document.parts, parts_lying(document), strict=True)
    return tuple(_solids(part, _lying(flat)) for part, flat in each)


def find_surface(document: Part, which: int | str) -> tuple[Array, Integers]:
    """Vertices (N, 3) in a state, and corners of panels (F, 4) or of the boards' triangles (F, 3).

    Where panels have a thickness it is the closed surfaces of the boards of all parts that are
    there, the sheet's first.
    """
    if document.boards is None:
        return document.state(which).positions, document.mesh.faces
    mesh = mesh_of(solids_in(document, which))
    return mesh.vertices, mesh.triangles


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
        names=tuple(chain.from_iterable(each.names for each in solids)),
        sides=np.concatenate([each.boards.sides for each in solids]),
        vertices=np.concatenate([each.vertices for each in surfaces]),
        triangles=joined,
        first_vertex=np.append(begins, starts[-1]),
        first_triangle=first,
    )


def _solids(part: Part, state: DocumentState) -> Solids:
    corners = part.boards_in(state)
    assert part.boards is not None
    names = tuple(part.board_name(board) for board in range(len(part.boards)))
    none: Integers = np.zeros(0, np.int64)
    drilled = none, np.zeros((0, 2, 3)), np.zeros(0)
    if part.holes is not None:
        flat = part.require_flat()
        drilled = part.holes.through(part.boards, part.mesh.faces, flat, state.positions)
    return Solids(names, part.boards, corners, *drilled)


def _lying(flat: Array) -> DocumentState:
    return DocumentState(np.column_stack([flat, np.zeros(len(flat))]))
