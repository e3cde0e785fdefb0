"""Triangles of surfaces and shells, samples of them, and the areas that samples stand for."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from orishell.conventions.record import record
from orishell.design import AskedSurface, Lattice, MeshSurface
from orishell.design.asked import Shifted
from orishell.motion.grid import Grid
from orishell.motion.quads import area_vectors, grid_corners, lengths, unit_normals
from orishell.numerics.arrays import Array, Integers

FLATNESS = 400.0
"""The mesh of a surface leaves it by about the samples' step over this."""
LONGEST_CELL = 8.0
"""Cells of the mesh are at most this many steps of the samples long."""
FINEST = 200_000
"""Cells of a mesh of a surface at most: 100 MB with its tree."""
AT_ONCE = 200_000
"""Points looked up at once, to bound the memory."""


At = Callable[[Array, Array], Array]
"""Points (..., 3) of a surface at two parameters (...)."""


@record
class Nearest:
    """The nearest points of a surface to given points (...)."""

    distances: Array
    feet: Array  # (..., 3), the nearest points
    cells: Integers  # (..., 2), rows and columns
    sides: Array  # (...): +1 on the side of the cell's normal, or -1


@record
class Triangles:
    """Triangles, of a grid of points (A, B, 3) whose cells are two triangles each, or scattered.

    Turning has, along rows and down columns of cells, running sums of how much edges turn from cell
    to cell, and of how much opposite edges of a cell differ, at most (radians). Of scattered ones,
    each of which is a cell, it is not known.
    """

    vertices: Array  # (A*B, 3)
    corners: Integers  # (T, 3), cell by cell
    columns: int  # of cells; 0 for scattered triangles
    turning: tuple[tuple[Array, Array], ...]
    tree: Any  # libigl's, of boxes

    @classmethod
    def of(cls, points: Array, corners: Integers) -> Triangles:
        """The triangles of a grid of points (A, B, 3), cell by cell, with what look-ups need."""
        import igl

        vertices, corners = points.reshape(-1, 3), np.ascontiguousarray(corners)
        tree = igl.AABB()
        tree.init(vertices, corners)
        turning = _turning(points), _turning(points.swapaxes(0, 1))
        return cls(vertices, corners, points.shape[1] - 1, turning, tree)

    @classmethod
    def scattered(cls, vertices: Array, corners: Integers) -> Triangles:
        """Triangles (T, 3) of vertices (V, 3), in any order."""
        import igl

        vertices, corners = np.ascontiguousarray(vertices), np.ascontiguousarray(corners)
        tree = igl.AABB()
        tree.init(vertices, corners)
        return cls(vertices, corners, 0, (), tree)

    def nearest(self, points: Array) -> Nearest:
        """The points of the triangles that are nearest to given points (..., 3)."""
        flat = np.ascontiguousarray(points.reshape(-1, 3))
        feet, cells = np.empty_like(flat), np.empty((len(flat), 2), np.int64)
        distances, sides = np.empty(len(flat)), np.empty(len(flat))
        for k in range(0, len(flat), AT_ONCE):
            part = slice(k, k + AT_ONCE)
            squares, index, foot = self.tree.squared_distance(
                self.vertices, self.corners, flat[part]
            )
            p, q, r = (self.vertices[self.corners[index, corner]] for corner in range(3))
            side = np.einsum("ij,ij->i", np.cross(q - p, r - p), flat[part] - foot)
            distances[part], feet[part] = np.sqrt(squares), foot
            if self.columns:
                cells[part] = np.stack(np.divmod(index // 2, self.columns), axis=-1)
            else:
                cells[part] = np.stack([index, np.zeros_like(index)], axis=-1)
            sides[part] = np.where(side < 0, -1.0, 1.0)
        shape = points.shape[:-1]
        return Nearest(
            distances.reshape(shape),
            feet.reshape(points.shape),
            cells.reshape(*shape, 2),
            sides.reshape(shape),
        )

    def turns(self, cells: Integers) -> Array:
        """How much the surface and its border turn (...) between cells (K, ..., 2), at most."""
        low, high = cells.min(axis=0), cells.max(axis=0)
        total = np.full(low.shape[:-1], 0.0 if self.columns else np.pi)
        for axis, (between, within) in enumerate(self.turning):
            first, last = low[..., axis], high[..., axis]
            total += between[last] - between[first] + within[last + 1] - within[first]
        return np.where((low == high).all(axis=-1), 0.0, total)


def mesh_shell(positions: Array) -> Triangles:
    """The panels of a shell, given by their vertices (rows, columns, 3): two triangles each."""
    faces = Grid(*positions.shape[:2]).faces_vertices()
    corners = faces[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)
    return Triangles.of(positions, corners)


def triangles_of(surface: AskedSurface) -> tuple[Array, Integers] | None:
    """Vertices and triangles of a surface that is a mesh, or a mesh moved; None of another."""
    if isinstance(surface, MeshSurface):
        return surface.piece.vertices, surface.piece.triangles
    if isinstance(surface, Shifted) and isinstance(surface.surface, MeshSurface):
        piece = surface.surface.piece
        return piece.vertices + surface.shift, piece.triangles
    return None


def mesh_surface(surface: AskedSurface, samples: int) -> tuple[Triangles, float]:
    """A mesh of a surface that suits so many samples, and how far it leaves the surface."""
    known = triangles_of(surface)
    if known is not None:
        return Triangles.scattered(*known), 0.0
    step = float(np.sqrt(surface.area() / samples))
    lattice = surface.lattice(LONGEST_CELL * step, step / FLATNESS, most=FINEST)
    triangles = Triangles.of(lattice.points, lattice.triangles())
    return triangles, sagitta(surface, lattice) + lattice.left_out


def sagitta(surface: AskedSurface, lattice: Lattice) -> float:
    """How far a lattice's triangles leave the surface, measured at the middles of their edges.

    Within the surface that is across them; at its border they may also end short of it, or beyond.
    """
    u, v, points = lattice.u, lattice.v, lattice.points
    middle_u, middle_v = 0.5 * (u[1:] + u[:-1]), 0.5 * (v[1:] + v[:-1])
    a, b, c, d = points[:-1, :-1], points[:-1, 1:], points[1:, 1:], points[1:, :-1]
    normals = unit_normals(np.stack([a, b, c, d], axis=-2))
    gaps = (
        surface.points(middle_u[:, None], middle_v[None, :]) - 0.5 * (a + c),
        surface.points(u[:-1, None], middle_v[None, :]) - 0.5 * (a + b),
        surface.points(middle_u[:, None], v[None, :-1]) - 0.5 * (a + d),
    )
    across = (np.abs(np.einsum("...i,...i->...", gap, normals)).max() for gap in gaps)
    ends_u, ends_v = points[[0, -1]], points[:, [0, -1]]
    border = (
        surface.points(u[[0, -1], None], middle_v[None, :])
        - 0.5 * (ends_u[:, 1:] + ends_u[:, :-1]),
        surface.points(middle_u[:, None], v[None, [0, -1]]) - 0.5 * (ends_v[1:] + ends_v[:-1]),
    )
    return float(max(*across, *(lengths(gap).max() for gap in border)))


def _turning(points: Array) -> tuple[Array, Array]:
    """Running sums, down the rows of cells of a grid (A, B, 3): turns between, and within them."""
    down, right = _directions(np.diff(points, axis=0)), _directions(np.diff(points, axis=1))
    between, within = _largest_angles(down), _largest_angles(right)
    return np.cumsum(np.concatenate([[0.0], between])), np.cumsum(np.concatenate([[0.0], within]))


def _directions(edges: Array) -> Array:
    """Unit vectors; not a number where an edge has no length."""
    length = lengths(edges)[..., None]
    return np.asarray(np.divide(edges, length, out=np.full_like(edges, np.nan), where=length > 0))


def _largest_angles(directions: Array) -> Array:
    """Largest angles (A-1,) between directions (A, B, 3) of neighbouring rows; pi for unknown."""
    chord = lengths(np.diff(directions, axis=0))
    angles = 2 * np.arcsin(np.minimum(0.5 * np.nan_to_num(chord, nan=2.0), 1.0))
    return np.asarray(angles.max(axis=1, initial=0.0))


MOST_LONGER = 30.0
"""Samples are at most so many times farther apart in one direction than in the other."""
MOST_TIMES, FEWEST_BOUND = 4, 20_000
"""A surface that bends often is sampled more often than asked for, at most so many times, or so
often."""
CACHED = 2**16
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
    def of_surface(cls, surface: AskedSurface, samples: int, shell: Array) -> Patch:
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
        step = max(CACHED // len(self.v), 1)
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
