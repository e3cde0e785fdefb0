"""A meshed sheet as parts to factorise.

Rotations at edges of panels are taken along the edge and across it: hinges join only those along
it, so that the other two are eliminated with the panel's inside.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.elements import Elements
from orishell.structure.mesh.sheet import SheetMesh
from orishell.structure.solve.dissection import Part, cut, turned
from orishell.structure.solve.fronts import Fronts, factorise_fronts

if TYPE_CHECKING:
    from scipy.sparse import csr_array

NOTHING = 1e-12
"""Rows of an element below this share of its largest entry are rounding."""


def condense(
    mesh: SheetMesh,
    grid: Grid,
    elements: Sequence[Elements],
    sprung: tuple[csr_array, Array],
    free: Integers,
) -> Fronts | None:
    """The matrix of free dofs, factorised; None if it is singular.

    elements: Panels, then what else there is.
    sprung: Rows (M, D) with springs, and these (M,).
    free: The dofs (n,) that are not supported.
    """
    number = np.full(mesh.count, -1)
    number[free] = np.arange(len(free))
    axes = _axes(mesh, number)
    panels, *others = elements
    cells = mesh.nodes.shape[1] - 1
    blocks = np.repeat(cut(grid.rows - 1, grid.columns - 1, cells).ravel(), 2)
    parts = [
        Part(panels.matrices, number[panels.dofs], blocks, _own(panels, axes)),
        *(_touched(turned(each.matrices, _own(each, axes)), number[each.dofs]) for each in others),
        _spring_part(*sprung, number),
    ]
    return factorise_fronts(parts, len(free), _turn(axes, free))


def _axes(mesh: SheetMesh, number: Integers) -> Array:
    """Axes (D/3, 3, 3), as rows, of displacements of nodes and of rotations of panels there."""
    axes = np.tile(np.eye(3), (mesh.count // 3, 1, 1))
    points = mesh.facets.points[mesh.seats]
    normal = _unit(
        np.cross(points[:, -1, -1] - points[:, 0, 0], points[:, 0, -1] - points[:, -1, 0])
    )
    place = mesh.node_count + np.arange(mesh.nodes.size).reshape(mesh.nodes.shape)
    for side in (np.s_[:, :, 0], np.s_[:, :, -1], np.s_[:, 0], np.s_[:, -1]):
        ends = points[side]
        along = _unit(ends[:, -1] - ends[:, 0])
        frame = np.stack([along, np.cross(normal, along), normal], axis=1)
        axes[place[side][:, 1:-1]] = frame[:, None]
    axes[(number.reshape(-1, 3) < 0).any(axis=1)] = np.eye(3)
    return axes


def _unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


def _own(elements: Elements, axes: Array) -> Array:
    """Axes (T, k/3, 3, 3) of the dofs of elements."""
    return axes[elements.dofs[:, ::3] // 3]


def _touched(matrices: Array, dofs: Integers) -> Part:
    """Elements without the dofs that they do not resist."""
    size = np.abs(matrices).max(axis=2)
    bare = size <= NOTHING * size.max(axis=1, keepdims=True)
    return Part(matrices, np.where(bare, -1, dofs), None)


def _spring_part(rows: csr_array, springs: Array, number: Integers) -> Part:
    """Rows with springs as elements."""
    length = np.diff(rows.indptr)
    filled = np.arange(int(length.max(initial=1))) < length[:, None]
    values, dofs = np.zeros(filled.shape), np.full(filled.shape, -1)
    values[filled], dofs[filled] = rows.data, number[rows.indices]
    return Part(springs[:, None, None] * values[:, :, None] * values[:, None], dofs, None)


def _turn(axes: Array, free: Integers) -> csr_array:
    """The matrix (n, n) that takes free dofs to their axes."""
    from scipy.sparse import bsr_array

    count = len(axes)
    blocks = bsr_array((axes, np.arange(count), np.arange(count + 1)), shape=(3 * count, 3 * count))
    return blocks.tocsr()[free][:, free]
