"""A meshed sheet factorised, as a symmetric matrix of elements: dense fronts in batches.

A front is the matrix of a part of the sheet: of the dofs e that are eliminated there, and those b
that others have as well. With A_ee = L L^T and Y = L^-1 A_eb what it adds to the part above it is
the Schur complement A_bb - Y^T Y. All panels are cut alike, so that fronts of one shape come by the
hundred, and are worked on together.

I. S. Duff and J. K. Reid, "The multifrontal solution of indefinite sparse symmetric linear
equations", ACM Transactions on Mathematical Software 9 (1983).

Rotations at edges of panels are taken along the edge and across it: hinges join only those along
it, so that the other two are eliminated with the panel's inside.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.elements import Elements
from orishell.structure.mesh.sheet import SheetMesh
from orishell.structure.solve.dissection import Part, cut, dissect, turned
from orishell.structure.solve.layout import Layout, Link

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
        *(_part(each, axes, number, blocks) for each in others),
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


def _part(elements: Elements, axes: Array, number: Integers, blocks: Integers) -> Part:
    """What joins panels, or, where it has dofs of its own, stands beside one of them."""
    dofs, own = number[elements.dofs], _own(elements, axes)
    if elements.beside is not None:
        return Part(elements.matrices, dofs, blocks[elements.beside], own)
    return _touched(turned(elements.matrices, own), dofs)


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


@record
class _Batch:
    """Fronts of one shape."""

    first: int  # where their own dofs begin in the order of elimination
    shared: Integers  # their dofs b (B, nb), in that order
    below: tuple[Link, ...]  # halves of these fronts
    inverse: Array  # L^-1 (B, ne, ne)
    across: Array  # Y (B, ne, nb)


@record
class Fronts:
    """A factorised matrix (n, n)."""

    batches: tuple[_Batch, ...]
    order: Integers  # dofs (n,) in the order of elimination
    turn: csr_array | None  # axes (n, n) in which elements are assembled; None for those of loads

    def solve(self, loads: Array) -> Array:
        """Displacements (n, ...) under loads (n, ...)."""
        given = loads.reshape(len(loads), -1)
        if self.turn is not None:
            given = self.turn @ given
        work = given[self.order]
        width = work.shape[1]
        up: list[Array | None] = []
        last = {below.group: k for k, batch in enumerate(self.batches) for below in batch.below}
        for number, batch in enumerate(self.batches):
            count, own, shared = batch.across.shape
            mine = slice(batch.first, batch.first + count * own)
            front = np.zeros((count, own + shared, width))
            front[:, :own] = work[mine].reshape(count, own, width)
            for below in batch.below:
                passed = up[below.group]
                assert passed is not None
                front[below.into[:, None], below.places] += passed[below.fronts]
            for below in batch.below:
                if last[below.group] == number:
                    up[below.group] = None
            solved = batch.inverse @ front[:, :own]
            work[mine] = solved.reshape(-1, width)
            up.append(front[:, own:] - batch.across.swapaxes(1, 2) @ solved)
        for batch in reversed(self.batches):
            count, own, shared = batch.across.shape
            mine = slice(batch.first, batch.first + count * own)
            solved = work[mine].reshape(count, own, width)
            if shared:
                solved = solved - batch.across @ work[batch.shared]
            work[mine] = (batch.inverse.swapaxes(1, 2) @ solved).reshape(-1, width)
        found = np.empty_like(work)
        found[self.order] = work
        if self.turn is not None:
            found = self.turn.T @ found
        return np.asarray(found.reshape(loads.shape))


def factorise_fronts(
    parts: Sequence[Part], count: int, turn: csr_array | None = None
) -> Fronts | None:
    """Factorise the sum of elements; None if it is singular.

    count: Number of dofs n.
    """
    layout = Layout.of(dissect(parts, count))
    batches: list[_Batch] = []
    rest: list[Array | None] = []
    for number, group in enumerate(layout.groups):
        matrices, own = layout.assembled(parts, number), group.own
        links = tuple(layout.below(number))
        for link in links:
            into, places = link.into, link.places
            part = rest[link.group]
            assert part is not None
            matrices[into[:, None, None], places[:, :, None], places[:, None]] += part[link.fronts]
        for link in links:
            if layout.last[link.group] == number:
                rest[link.group] = None
        try:
            inverse = np.linalg.inv(np.linalg.cholesky(matrices[:, :own, :own]))
        except np.linalg.LinAlgError:
            return None
        across = inverse @ matrices[:, :own, own:]
        rest.append(matrices[:, own:, own:] - across.swapaxes(1, 2) @ across)
        shared = layout.place[group.dofs[:, own:]]
        batches.append(_Batch(int(layout.place[group.dofs[0, 0]]), shared, links, inverse, across))
    return Fronts(tuple(batches), layout.order, turn)
