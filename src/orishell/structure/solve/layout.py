"""Fronts of a dissection, those of one shape together: their dofs, and who is half of whom."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.structure.solve.dissection import Dissection, Part, depth

AT_ONCE = 4_000_000
"""Numbers in the fronts of a batch, at most, unless it has one front only: 32 MB."""
STAGE = 512
"""About so many blocks are eliminated, with all that is above them up to the part which has no
others, before the next: fronts that wait for what is above them take memory."""


@record
class Group:
    """Fronts of one shape."""

    parts: Integers  # which parts (B,) of the sheet they are, by their number in ``Layout.parts``
    own: int  # number of dofs that are eliminated in each
    dofs: Integers  # their dofs (B, n), those of their own first


@record
class Link:
    """Fronts of another group that are halves of fronts of this one."""

    group: int  # which group
    fronts: Integers  # which of its fronts (k,)
    into: Integers  # of which fronts (k,) of this group they are halves
    places: Integers  # where their shared dofs are in these (k, nb)


@record
class Layout:
    """All fronts."""

    groups: tuple[Group, ...]  # in the order in which they are eliminated
    order: Integers  # dofs (n,) in the order of elimination
    place: Integers  # where every dof (n,) is in that
    last: Integers  # the last group (g,) that has halves in every group
    _plan: Dissection
    _parts: Integers  # all parts (P,), as heap numbers
    _keys: Integers  # all dofs of all parts, as numbers
    _start: Integers  # where those of every part begin
    _group: Integers  # the group (P,) of every part
    _row: Integers  # and which of its fronts it is

    @classmethod
    def of(cls, plan: Dissection) -> Layout:
        """The fronts of a dissection."""
        count = len(plan.eliminated)
        keys = _all_keys(plan)
        both, dof = np.divmod(keys, count)
        part, shared = np.divmod(both, 2)
        parts, start, size = np.unique(part, return_index=True, return_counts=True)
        extra = np.add.reduceat(shared, start)
        stage = _stages(parts, len(np.unique(plan.blocks)))
        ranks = (extra, size - extra, -depth(parts), stage)
        order = np.lexsort(ranks)
        new = np.any([each[order][1:] != each[order][:-1] for each in ranks], axis=0)
        groups: list[Group] = []
        group, row = np.empty((2, len(parts)), np.int64)
        for alike in np.split(order, np.flatnonzero(new) + 1):
            length = int(size[alike[0]])
            many = max(1, AT_ONCE // length**2)
            for some in np.split(alike, range(many, len(alike), many)):
                dofs = dof[start[some, None] + np.arange(length)]
                group[some], row[some] = len(groups), np.arange(len(some))
                groups.append(Group(some, length - int(extra[some[0]]), dofs))
        sequence = np.concatenate([each.dofs[:, : each.own].ravel() for each in groups])
        place = np.empty(count, np.int64)
        place[sequence] = np.arange(count)
        last = np.full(len(groups), -1)
        above = np.searchsorted(parts, parts >> 1)
        np.maximum.at(last, group[parts > 1], group[above[parts > 1]])
        return cls(tuple(groups), sequence, place, last, plan, parts, keys, start, group, row)

    def assembled(self, elements: Sequence[Part], number: int) -> Array:
        """The matrices (B, n, n) of a group, of the elements that are assembled there."""
        fronts, length = self.groups[number].dofs.shape
        total = np.zeros(fronts * length**2)
        for part, where in zip(elements, self._plan.parts, strict=True):
            part_of = np.searchsorted(self._parts, where)
            which = np.flatnonzero(self._group[part_of] == number)
            dofs = part.dofs[which]
            kept = dofs >= 0
            at = self._places(part_of[which, None], np.where(kept, dofs, 0))
            flat = (self._row[part_of[which], None, None] * length + at[:, :, None]) * length
            both = kept[:, :, None] & kept[:, None]
            keys = (flat + at[:, None])[both]
            total += np.bincount(keys, part.stiffness(which)[both], len(total))
        return total.reshape(fronts, length, length)

    def below(self, number: int) -> Iterator[Link]:
        """The halves of the fronts of a group: left ones, then right ones, of each other group."""
        parts = self.groups[number].parts
        for side in (0, 1):
            half = 2 * self._parts[parts] + side
            found = np.minimum(np.searchsorted(self._parts, half), len(self._parts) - 1)
            into = np.flatnonzero(self._parts[found] == half)
            found = found[into]
            for group in np.unique(self._group[found]):
                mine = self._group[found] == group
                fronts = self._row[found[mine]]
                shared = self.groups[group].dofs[fronts, self.groups[group].own :]
                places = self._places(parts[into[mine], None], shared)
                yield Link(int(group), fronts, into[mine], places)

    def _places(self, parts: Integers, dofs: Integers) -> Integers:
        """Where dofs are in the fronts of parts, which are numbers in ``_parts``."""
        names = self._parts[parts]
        keys = _joint(names, self._plan.eliminated[dofs] != names, dofs, len(self.order))
        return np.asarray(np.searchsorted(self._keys, keys) - self._start[parts])


def _joint(parts: Integers, shared: Booleans, dofs: Integers, count: int) -> Integers:
    """Numbers in whose order dofs of one part are neighbours, those of its own first."""
    return np.asarray((2 * parts + shared) * count + dofs)


def _all_keys(plan: Dissection) -> Integers:
    """All dofs of all parts, from blocks up to the whole."""
    count = len(plan.eliminated)
    deep, found = depth(plan.blocks), []
    passed = np.zeros(0, np.int64)
    for level in range(int(deep.max()), -1, -1):
        own = deep == level
        part, dof = np.divmod(passed, count)
        part, dof = np.append(part, plan.blocks[own]), np.append(dof, plan.dofs[own])
        shared = plan.eliminated[dof] != part
        found.append(_joint(part, shared, dof, count))
        passed = np.unique((part[shared] >> 1) * count + dof[shared])
    return np.sort(np.concatenate(found))


def _stages(parts: Integers, blocks: int) -> Integers:
    """By which parts are eliminated first: in order of the part of so many blocks that has them."""
    deep = depth(parts)
    cuts = max(0, blocks // STAGE).bit_length()
    return np.where(deep >= cuts, parts >> np.maximum(deep - cuts, 0), 2 << cuts)
