r"""Normal equations of things that hang together in a sheet, factorised level by level.

Unknowns belong to things, so many to each, and only neighbours are coupled. Things are sorted by
levels: how many steps they are from the first. Only things of one level, or of two that follow
each other, are neighbours, so that a matrix A falls into blocks A_kk, A_k,k+1. Eliminating level
after level,

    D_0 = A_00,   D_k = A_kk - A_k,k-1 U_k-1,   U_k = D_k^-1 A_k,k+1,

leaves as many dense blocks as there are levels. In a sheet of R x C panels these are R + C - 1 of
at most min(R, C) panels. The blocks of the inverse S next to the diagonal follow from the last
level back (K. Takahashi, J. Fagan and M.-S. Chen, 8th PICA Conference, 1973):

    S_kl = -U_k S_k+1,l for l > k,   S_kk = D_k^-1 - U_k S_k+1,k.
"""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.components import find_components

if TYPE_CHECKING:
    from scipy.sparse import csr_array


@record
class Levels:
    """An order of things (F,) by which only those of levels that follow each other are coupled."""

    order: Integers  # numbers (F,) of things, level by level
    cuts: Integers  # where levels begin in it (L + 1,), the end of the last one included

    @classmethod
    def of(cls, pairs: Integers, count: int) -> Levels:
        """Levels of so many things of which pairs (N, 2) are neighbours."""
        from scipy.sparse import coo_array
        from scipy.sparse.csgraph import dijkstra

        ends = pairs.T.astype(np.int32)  # SciPy before 1.14 finds no ways by longer numbers
        graph = coo_array((np.ones(len(pairs)), ends), shape=(count, count)).tocsr()
        # What does not hang together begins with a thing of its own.
        pieces = find_components(pairs, count)
        starts = np.unique(pieces, return_index=True)[1]
        steps = dijkstra(graph, directed=False, unweighted=True, indices=starts, min_only=True)
        level = steps.astype(np.int64)
        return cls(np.argsort(level, kind="stable"), np.r_[0, np.bincount(level).cumsum()])


@record
class Blocks:
    """A symmetric positive definite matrix (n, n), factorised by levels."""

    unknowns: Integers  # numbers (n,) of unknowns, level by level
    cuts: Integers  # where the levels' unknowns begin (L + 1,)
    inverses: list[Array]  # D_k^-1
    spreads: list[Array]  # U_k, one less

    @classmethod
    def of(cls, matrix: csr_array, levels: Levels) -> Blocks:
        """Factorise a matrix of things in levels, as many unknowns to each, one after another.

        Raises numpy.linalg.LinAlgError if it is singular.
        """
        each = matrix.shape[0] // len(levels.order)
        unknowns = (each * levels.order[:, None] + np.arange(each)).ravel()
        cuts = each * levels.cuts
        sorted_ = matrix[unknowns][:, unknowns].tocsr()
        inverses: list[Array] = []
        spreads: list[Array] = []
        taken = np.zeros(())  # what levels before take from a level's block
        for k, (start, stop) in enumerate(pairwise(cuts)):
            rows = sorted_[start:stop]
            inverses.append(np.asarray(np.linalg.inv(rows[:, start:stop].toarray() - taken)))
            if k + 2 < len(cuts):
                coupling = rows[:, stop : cuts[k + 2]].toarray()
                spreads.append(inverses[-1] @ coupling)
                taken = coupling.T @ spreads[-1]
        return cls(unknowns, cuts, inverses, spreads)

    def solve(self, loads: Array) -> Array:
        """A^-1 b of loads b (n, p)."""
        rest = np.split(loads[self.unknowns], self.cuts[1:-1])
        for k, spread in enumerate(self.spreads):
            rest[k + 1] = rest[k + 1] - spread.T @ rest[k]
        found = [inverse @ each for inverse, each in zip(self.inverses, rest, strict=True)]
        for k in reversed(range(len(self.spreads))):
            found[k] -= self.spreads[k] @ found[k + 1]
        moved = np.empty_like(loads)
        moved[self.unknowns] = np.concatenate(found)
        return moved

    def trace(self, other: csr_array, reach: int) -> float:
        """The trace of A^-1 B, where B (n, n) couples things at most ``reach`` levels apart."""
        sorted_ = other[self.unknowns][:, self.unknowns].tocsr()
        ends = self.cuts[1:]
        total = 0.0
        row: list[Array] = []  # of the inverse: a level's blocks from its diagonal on
        for k in reversed(range(len(self.inverses))):
            beside = [-self.spreads[k] @ each for each in row[:reach]]
            own = self.inverses[k]
            row = [own - self.spreads[k] @ beside[0].T if beside else own, *beside]
            start, stop = self.cuts[k], self.cuts[k + 1]
            part = sorted_[start:stop, start : ends[k + len(row) - 1]].tocoo()
            twice = np.where(part.col < stop - start, 1.0, 2.0)
            total += float((twice * part.data) @ np.hstack(row)[part.row, part.col])
        return total
