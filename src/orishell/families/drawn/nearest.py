"""A sheet nearby that folds exactly, in place of one that does not: the nearest of its kind.

Sheets that fold make up surfaces among all sheets. Where vertices are flat-foldable, or creases go
straight on, conditions round panels alone do not tell their tangents: they hold twice over, as x^2
does at 0. So single vertices are asked to be of the kinds that they nearly are, and then conditions
are regular (module ``conditions``). Least ``|x - x0|^2`` subject to them: Newton's steps to a place
where x - x0 is square to the surface, damped as long as much is missing. More conditions than are
independent do no harm. Not in the paper: docs/theory/vertex.md.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from orishell.conventions.record import record
from orishell.families.drawn.conditions import Conditions
from orishell.families.drawn.drive import Drive
from orishell.numerics.arrays import Array, Booleans
from orishell.numerics.equals import smallest_of

if TYPE_CHECKING:
    from scipy.sparse import csr_array

DRIVES = np.array([0.4, 0.9, 1.4, 2.0])
"""Drives at which vertices are to agree (radians)."""
FOLDS = 1e-10
"""A sheet folds exactly, as far as can be told, if vertices disagree by less (radians)."""
MOST_MOVED = 15_000
"""Vertices of the largest sheets that are moved: beyond, the work takes minutes."""
INDEPENDENT = 1e-14
"""Combinations of conditions that change by a smaller square are none of their own."""
STEPS, CLOSING = 30, 5
"""The most steps along the surface, and of those after them that only bring the sheet onto it."""
SETTLED, ROUNDED = 1e-7, 1e-5
"""Steps that are smaller by the way from the sheet end the first; so do those that are smaller and
do not shrink, as they are rounding."""
LEAST_MISS = 1e-15
"""Conditions are met if they miss by no more: sums of angles are not known better (radians)."""
REFINED, LEFT = 5, 1e-10
"""How often what multipliers leave is given to them again, unless they take less than a share."""
SQUARE = 1e-6
"""The way is square to the surface if they leave less of it."""
MARGIN = 0.5
"""The least growth of ``|x - x0|^2`` by ``|y - x|^2`` on the surface that shows the nearest place;
1 if the surface is flat."""


@record
class Nearby:
    """A sheet that folds, near one that does not."""

    vertices: Array  # (rows, columns, 2)
    # by how much the way to it is not square to the surface of all sheets of its kind that fold:
    # what Lagrange's multipliers leave of it, as a share
    leaves: float
    # whether it is the nearest such sheet far and wide: the way is square to the surface, which
    # does not curve towards the sheet by more than half of what would make another one nearer
    nearest: bool


def disagreement(drive: Drive, drives: Array = DRIVES) -> float:
    """The largest disagreement of vertices at some drives (radians), inf where a crease closed."""
    found = np.abs(drive.disagreement(drives)).max(initial=0.0)
    return float(found) if np.isfinite(found) else np.inf


def find_nearby(flat: Array, drive: Drive) -> Nearby | None:
    """A sheet near another one (rows, columns, 2), that folds; None if none is found.

    Mountains and valleys stay what they are.
    """
    if flat[..., 0].size > MOST_MOVED:
        return None
    places = np.moveaxis(flat, -1, 0)
    own = places.swapaxes(1, 2)[::-1] if drive.across else places
    found = []
    with np.errstate(all="ignore"):
        conditions = Conditions.of(own, drive)
        for kinds in _kinds(conditions.nearly(own)):
            nearby = _projected(replace(conditions, kinds=conditions.kinds | kinds), own)
            if nearby is None:
                continue
            place = nearby.vertices
            place = place.swapaxes(1, 2)[::-1] if drive.across else place
            if disagreement(drive.moved(place[..., None])) < FOLDS:
                found.append(replace(nearby, vertices=np.moveaxis(place, 0, -1)))
                if nearby.nearest:
                    return found[-1]
    if not found:
        return None
    return smallest_of(found, lambda each: float(np.linalg.norm(each.vertices - flat)))


def _kinds(nearly: Booleans) -> Iterator[Booleans]:
    """Which kinds (3, R, C) vertices may have: one is enough, the first or those that are last."""
    foldable, *straight = nearly
    yield np.stack([foldable, *(each & ~foldable for each in straight)])
    if (foldable & (straight[0] | straight[1])).any():
        yield np.stack([foldable & ~straight[0] & ~straight[1], *straight])


def _projected(conditions: Conditions, start: Array) -> Nearby | None:
    """Where the conditions hold (2, rows, columns), as near to the start as may be; None if lost.

    The work is that of factors of a sparse matrix.
    """
    places, edge = start, float(np.median(np.linalg.norm(np.diff(start, axis=1), axis=0)))
    before = np.inf
    for _ in range(STEPS):
        missing, slopes, sizes = _scaled(conditions, places)
        size = np.abs(missing).max(initial=0.0) / edge
        if not np.isfinite(size) or not np.isfinite(slopes.data).all():
            return None
        factors = _Factors.of(slopes, max(INDEPENDENT, size * size))
        along, _ = factors.split((start - places).ravel())
        onto, _ = factors.solve(np.zeros(places.size), -missing)
        places = places + (along + onto).reshape(places.shape)
        step, way = (float(np.abs(each).max()) for each in (along + onto, places - start))
        if step <= SETTLED * way or 0.5 * before < step <= ROUNDED * way:
            break
        before = step
    before = np.inf
    for _ in range(CLOSING):
        misses = conditions.misses(places)
        largest = np.abs(misses).max(initial=0.0)
        if not LEAST_MISS < largest < 0.5 * before:
            break
        before = largest
        onto, _ = factors.solve(np.zeros(places.size), -misses / sizes)
        places = places + onto.reshape(places.shape)
    return _judged(conditions, start, places)


def _judged(conditions: Conditions, start: Array, places: Array) -> Nearby:
    """What first and second derivatives say of a place where the conditions hold."""
    from scipy.sparse import eye_array

    _, slopes, sizes = _scaled(conditions, places)
    way = (start - places).ravel()
    left, forces = _Factors.of(slopes, INDEPENDENT).split(way)
    size = float(np.linalg.norm(way))
    leaves = float(np.linalg.norm(left)) / size if size > 0 else 0.0
    nearest = False
    if leaves < SQUARE:
        bends = conditions.bends(places, forces / sizes)
        curved = (1 - MARGIN) * eye_array(len(way)) + 0.5 * (bends + bends.T)
        nearest = _Factors.of(slopes, INDEPENDENT, curved).convex
    return Nearby(places, leaves, nearest)


def _scaled(conditions: Conditions, places: Array) -> tuple[Array, csr_array, Array]:
    """Misses (N,) as lengths, their derivatives, whose rows are unit vectors, and their sizes."""
    from scipy.sparse import csr_array, diags_array

    slopes = conditions.derivatives(places)
    sizes = np.sqrt((slopes * slopes).sum(axis=1))
    sizes = np.where(sizes > 0, sizes, 1.0)
    return conditions.misses(places) / sizes, csr_array(diags_array(1 / sizes) @ slopes), sizes


@record
class _Factors:
    """Of the matrix ((H, J^T), (J, -e)): H = 1, or second derivatives; J slopes."""

    matrix: Any
    factors: Any
    count: int  # rows of H

    @classmethod
    def of(cls, slopes: csr_array, little: float, curved: Any = None) -> _Factors:
        from scipy.sparse import block_array, eye_array
        from scipy.sparse.linalg import splu

        rows, count = slopes.shape
        matrix = block_array(
            [
                [eye_array(count) if curved is None else curved, slopes.T],
                [slopes, -little * eye_array(rows)],
            ],
            format="csc",
        )
        options = {"SymmetricMode": True}
        factors = splu(matrix, "MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options)
        return cls(matrix, factors, count)

    def solve(self, first: Array, second: Array) -> tuple[Array, Array]:
        """Both parts of what it takes to both parts given, refined once."""
        given = np.concatenate([first, second])
        found = self.factors.solve(given)
        found = found + self.factors.solve(given - self.matrix @ found)
        return found[: self.count], found[self.count :]

    def split(self, way: Array) -> tuple[Array, Array]:
        """A way less its part square to the surface, and multipliers, whose J^T are that part."""
        left, forces = way, np.zeros(self.matrix.shape[0] - self.count)
        for _ in range(REFINED):
            before = left
            left, more = self.solve(before, np.zeros(len(forces)))
            forces = forces + more
            if np.abs(before - left).max() <= LEFT * np.abs(way).max():
                break
        return left, forces

    @property
    def convex(self) -> bool:
        """Whether H + J^T J/e is positive definite: by signs of pivots, if all are diagonal."""
        diagonal = bool((self.factors.perm_r == self.factors.perm_c).all())
        return diagonal and int((self.factors.U.diagonal() > 0).sum()) == self.count
