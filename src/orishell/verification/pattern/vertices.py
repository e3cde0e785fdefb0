"""Conditions at single vertices of a flat sheet."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following.rigid import sectors_between
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.equals import descending


@record
class VertexConditions:
    """Whether every vertex by itself folds flat, by Kawasaki's and by Maekawa's condition.

    Creases that stay flat count for nothing.
    """

    vertices: Integers  # numbers (I,) of the inner vertices
    kawasaki: Array  # by how much every other sector misses 180 degrees (I,); infinite if odd
    # mountains less valleys (I,), 2 or -2 where it may fold flat; NaN where letters are missing
    maekawa: Array
    limits: Array  # allowed misses (I,) of angles (radians)

    @property
    def not_kawasaki(self) -> Integers:
        """Numbers of the vertices at which Kawasaki's condition fails, worst first."""
        return self._failing(self.kawasaki > self.limits, self.kawasaki)

    @property
    def not_maekawa(self) -> Integers:
        """Numbers of those at which Maekawa's fails, worst first; missing letters do not count."""
        known = ~np.isnan(self.maekawa)
        return self._failing(known & (np.abs(self.maekawa) != 2), np.abs(self.maekawa))

    def _failing(self, fails: Booleans, miss: Array) -> Integers:
        here = np.flatnonzero(fails)
        return self.vertices[here[descending(miss[here])]]


def find_conditions(pattern: CreasePattern, limits: Array) -> VertexConditions:
    """Measure the vertices of a flat sheet that have creases which may fold.

    Parameters
    ----------
    limits
        Allowed misses (I,) of angles at its inner vertices (radians).
    """
    folds = pattern.crease & (pattern.signs != 0)
    between, count = sectors_between(pattern, folds)
    kawasaki = np.where(count % 2 == 0, np.abs(between[:, ::2].sum(axis=1) - np.pi), np.inf)
    creases, _ = pattern.fans
    signs = np.append(np.where(folds, pattern.signs, 0.0), 0.0)[creases]
    here = count > 0
    return VertexConditions(
        pattern.inner[here], kawasaki[here], -signs.sum(axis=1)[here], limits[here]
    )


def shortest_creases(pattern: CreasePattern) -> Array:
    """The shortest crease (I,) at every inner vertex of a pattern."""
    creases, ends = pattern.fans
    if not creases.size:
        return np.zeros(len(creases))
    way = pattern.vertices[ends] - pattern.vertices[pattern.inner][:, None]
    lengths = np.where(creases >= 0, np.linalg.norm(way, axis=-1), np.inf)
    return np.asarray(lengths.min(axis=1))
