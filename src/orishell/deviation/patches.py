"""Samples of a surface given by two parameters, and the areas that they stand for."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.record import record
from orishell.design import Surface
from orishell.deviation.branch_and_bound import At
from orishell.motion.quads import area_vectors, grid_corners, lengths
from orishell.numerics.arrays import Array

MOST_LONGER = 30.0
"""Samples are at most so many times farther apart in one direction than in the other."""
MOST_TIMES, FEWEST_BOUND = 4, 20_000
"""A surface that bends often is sampled more often than asked for, at most so many times, or so
often."""
AT_ONCE = 2**16
"""Cells that are looked at together: few enough for a processor's cache."""


@record
class Patch:
    """Samples of a surface at every pair of a value of u and a value of v.

    What is left out is how far corners of the surface that are not sampled are from what joins the
    samples.
    """

    at: At  # points (..., 3) at both parameters
    u: Array  # (A,), increasing
    v: Array  # (B,), increasing
    points: Array  # (A, B, 3)
    left_out: float

    @classmethod
    def of_shell(
        cls, positions: Array, samples: int, *, least: int = 2, longer: float | None = None
    ) -> Patch:
        """About ``samples`` samples of a shell's panels, given its vertices (rows, columns, 3).

        The parameters are row and column. However many panels there are, each of their edges has
        at least ``least`` steps: with 2 edges and insides of all are among the samples, with 1 the
        corners. Steps along rows are ``longer`` than those down columns, as much as the panels if
        nothing is said.
        """

        def at(u: Array, v: Array) -> Array:
            i, j = (
                np.clip(np.floor(each), 0, count - 2).astype(np.intp)
                for each, count in zip((u, v), positions.shape[:2], strict=True)
            )
            p, q = (u - i)[..., None], (v - j)[..., None]
            above = positions[i, j] * (1 - q) + positions[i, j + 1] * q
            below = positions[i + 1, j] * (1 - q) + positions[i + 1, j + 1] * q
            return np.asarray(above * (1 - p) + below * p)

        # Every panel alike in both directions: as many steps as its longest edge has.
        down = lengths(np.diff(positions, axis=0)).max(axis=1)
        right = lengths(np.diff(positions, axis=1)).max(axis=0)
        step = np.sqrt(down.sum() * right.sum() / samples)
        stretch = np.sqrt(_slenderness(positions) if longer is None else longer)
        u, v = (
            _divided(np.maximum(np.rint(each / (step * share)), least))
            for each, share in ((down, 1 / stretch), (right, stretch))
        )
        return cls(at, u, v, at(u[:, None], v[None, :]), 0.0)

    @classmethod
    def of_surface(cls, surface: Surface, samples: int, shell: Array) -> Patch:
        """About ``samples`` samples of a surface, spaced in proportion to a shell's panels.

        The shell is given by its vertices (rows, columns, 3).
        """
        longer = _slenderness(shell)
        step = np.sqrt(surface.area() / (longer * samples))
        most = max(MOST_TIMES * samples, FEWEST_BOUND)
        lattice = surface.lattice(step, longer=longer, most=most)
        return cls(surface.points, lattice.u, lattice.v, lattice.points, lattice.left_out)

    def spread(self, distances: Array) -> tuple[Array, Array]:
        """Distances (P,) inside the cells, bilinear between samples (A, B), and shares of the area.

        At Gauss points, two by two a cell, so that squares are integrated exactly.
        """
        near = 0.5 + np.sqrt(1 / 12)
        for _ in range(2):  # along both parameters
            first, second = distances[:-1], distances[1:]
            pairs = (near * first + (1 - near) * second, near * second + (1 - near) * first)
            distances = np.stack(pairs, axis=1).reshape(-1, distances.shape[1]).T
        areas = np.concatenate(
            [lengths(area_vectors(grid_corners(self.points[part]))) for part in self._blocks()]
        )
        shares = np.repeat(np.repeat(areas / (4 * areas.sum()), 2, axis=0), 2, axis=1)
        return distances.ravel(), shares.ravel()

    def radius(self) -> float:
        """A length within which every point of a cell has a corner of it, in all cells."""
        return max(self._radius(part) for part in self._blocks())

    def _radius(self, part: slice) -> float:
        u, v, points = self.u[part], self.v, self.points[part]
        middle = self.at(0.5 * (u[:-1] + u[1:])[:, None], 0.5 * (v[:-1] + v[1:])[None, :])
        corners = grid_corners(points)
        to_middle = lengths(corners - middle[..., None, :]).max(axis=-1)
        edges = lengths(corners - np.roll(corners, 1, axis=-2)).max(axis=-1)
        return float(np.maximum(to_middle, 0.5 * edges).max())

    def _blocks(self) -> Iterator[slice]:
        """Rows of samples to look at together: all cells, a few at once."""
        step = max(AT_ONCE // len(self.v), 1)
        for start in range(0, len(self.u) - 1, step):
            yield slice(start, start + step + 1)


def _slenderness(shell: Array) -> float:
    """How many times longer panels are along g than down f, within limits."""
    wide = lengths(np.diff(shell, axis=1)).mean()
    high = lengths(np.diff(shell, axis=0)).mean()
    return float(np.clip(wide / high, 1 / MOST_LONGER, MOST_LONGER))


def _divided(parts: Array) -> Array:
    """0, 1, 2 ... K with every unit divided into a number of parts (K,)."""
    counts = parts.astype(np.intp)
    unit = np.repeat(np.arange(len(counts)), counts)
    within = np.arange(len(unit)) - np.repeat(np.cumsum(counts) - counts, counts)
    return np.concatenate([unit + within / counts[unit], [float(len(counts))]])
