"""Which part of a sheet is eliminated when: nested dissection.

The sheet is cut in two again and again, along creases down to single panels, and these down to
blocks of a few cells. Parts are numbered as in a heap: 1 is the whole, 2 k and 2 k + 1 are the
halves of part k. A degree of freedom is eliminated in the smallest part that has all elements
which it belongs to.

A. George, "Nested dissection of a regular finite element mesh", SIAM Journal on Numerical Analysis
10 (1973).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers

BLOCK = 4
"""Cells along a side of a block, at most."""


@record
class Part:
    """Elements of one kind as they are assembled."""

    matrices: Array  # stiffness (T, k, k)
    dofs: Integers  # their dofs (T, k); -1 where one is restrained, or not touched
    # the block (T,) of each, numbered as in a heap; None if they belong to no block
    blocks: Integers | None
    axes: Array | None = None  # axes (T, k/3, 3, 3), as rows, of their dofs; None if not turned

    def stiffness(self, which: Integers) -> Array:
        """Stiffness (t, k, k) of some elements (t,) in these axes."""
        matrices = self.matrices[which]
        return matrices if self.axes is None else turned(matrices, self.axes[which])


def turned(matrices: Array, axes: Array) -> Array:
    """Matrices (T, k, k) in other axes (T, k/3, 3, 3) of their dofs."""
    count, size = axes.shape[:2]
    wide = np.zeros((count, size, 3, size, 3))
    for each in range(size):
        wide[:, each, :, each] = axes[:, each]
    turn = wide.reshape(count, 3 * size, 3 * size)
    return np.asarray(turn @ matrices @ turn.swapaxes(1, 2))


@record
class Dissection:
    """Where dofs are eliminated, and elements assembled."""

    parts: tuple[Integers, ...]  # where elements of every kind are assembled (T,), as heap numbers
    eliminated: Integers  # where every dof is eliminated (n,)
    # pairs of a block and a dof in it, by block
    blocks: Integers
    dofs: Integers


def cut(rows: int, columns: int, cells: int) -> Integers:
    """Blocks (rows, columns, cells, cells) that cells of panels are in, as heap numbers."""
    shape = rows * cells, columns * cells
    low, high = np.zeros((2, *shape), np.int64), np.empty((2, *shape), np.int64)
    high[0], high[1] = shape
    place, number = np.indices(shape), np.ones(shape, np.int64)
    while True:
        size = high - low
        several = (size > cells).any(axis=0)  # of several panels, between which it is cut
        if not (several | (size > BLOCK).any(axis=0)).any():
            return number.reshape(rows, cells, columns, cells).swapaxes(1, 2)
        unit = np.where(several, cells, 1)
        across = (size[1] > size[0]).astype(np.int64)
        along = np.take_along_axis(size, across[None], axis=0)[0]
        open_ = several | (along > BLOCK)
        middle = np.take_along_axis(low, across[None], axis=0)[0] + along // unit // 2 * unit
        behind = open_ & (np.take_along_axis(place, across[None], axis=0)[0] >= middle)
        number = np.where(open_, 2 * number + behind, number)
        for axis in (0, 1):
            here = open_ & (across == axis)
            low[axis] = np.where(here & behind, middle, low[axis])
            high[axis] = np.where(here & ~behind, middle, high[axis])


def dissect(parts: Sequence[Part], count: int) -> Dissection:
    """Where to eliminate and to assemble.

    count: Number of all dofs n, each of which some element of a block has.
    """
    pairs = [_pairs(each, count) for each in parts if each.blocks is not None]
    block, dof = np.divmod(np.unique(np.concatenate(pairs)), count)
    named, at = np.unique(block, return_inverse=True)
    # From left to right, so that all of a part are neighbours.
    ranked = np.argsort(_aligned(named))
    rank = np.argsort(ranked)[at]
    first, last = np.full(count, len(named)), np.full(count, -1)
    np.minimum.at(first, dof, rank)
    np.maximum.at(last, dof, rank)
    # An element that belongs to no block is in the part of all blocks that its dofs are in; so they
    # are eliminated there, or above.
    from_, to, where = first.copy(), last.copy(), []
    for part in parts:
        if part.blocks is not None:
            where.append(part.blocks)
            continue
        touched = part.dofs >= 0
        begin = np.where(touched, first[part.dofs], count).min(axis=1)
        end = np.where(touched, last[part.dofs], -1).max(axis=1)
        np.minimum.at(from_, part.dofs[touched], np.repeat(begin, touched.sum(axis=1)))
        np.maximum.at(to, part.dofs[touched], np.repeat(end, touched.sum(axis=1)))
        some, common = touched.any(axis=1), np.ones(len(touched), np.int64)
        common[some] = _common(named[ranked[begin[some]]], named[ranked[end[some]]])
        where.append(common)
    eliminated = _common(named[ranked[from_]], named[ranked[to]])
    return Dissection(tuple(where), eliminated, block, dof)


def _pairs(part: Part, count: int) -> Integers:
    """Numbers of a block times ``count``, and a dof in it."""
    assert part.blocks is not None
    keys = part.blocks[:, None] * count + part.dofs
    return np.unique(keys[part.dofs >= 0])


def depth(parts: Integers) -> Integers:
    """How many cuts parts are below the whole."""
    return np.asarray(np.frexp(parts.astype(np.float64))[1] - 1)


def _aligned(parts: Integers) -> Integers:
    """Numbers by which parts of any depth are in order from left to right."""
    deep = depth(parts)
    return np.asarray(parts << (deep.max() - deep))


def _common(first: Integers, second: Integers) -> Integers:
    """The smallest parts that have both of two."""
    while (first != second).any():
        first, second = (
            np.where(first > second, first >> 1, first),
            np.where(second > first, second >> 1, second),
        )
    return first
