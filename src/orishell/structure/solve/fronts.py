"""A symmetric matrix of elements factorised: dense fronts in batches.

A front is the matrix of a part of the sheet: of the dofs e that are eliminated there, and those b
that others have as well. With A_ee = L L^T and Y = L^-1 A_eb what it adds to the part above it is
the Schur complement A_bb - Y^T Y. All panels are cut alike, so that fronts of one shape come by the
hundred, and are worked on together.

I. S. Duff and J. K. Reid, "The multifrontal solution of indefinite sparse symmetric linear
equations", ACM Transactions on Mathematical Software 9 (1983).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.structure.solve.dissection import Part, dissect
from orishell.structure.solve.layout import Layout, Link

if TYPE_CHECKING:
    from scipy.sparse import csr_array


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
        up: list[Array] = []
        for batch in self.batches:
            count, own, shared = batch.across.shape
            mine = slice(batch.first, batch.first + count * own)
            front = np.zeros((count, own + shared, width))
            front[:, :own] = work[mine].reshape(count, own, width)
            for below in batch.below:
                front[below.into[:, None], below.places] += up[below.group][below.fronts]
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
