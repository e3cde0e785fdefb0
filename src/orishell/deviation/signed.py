"""Signed distances of points of a shell from a surface: for pictures, and of single points."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.design import AskedSurface
from orishell.deviation.triangles import Patch, mesh_surface
from orishell.numerics.arrays import Array, Booleans, Integers


@record
class SignedDistances:
    """Distances of points of a shell, positive on the side of the surface's normals."""

    points: Array  # the points (A, B, 3), by rows and columns of the shell
    distances: Array  # their distances (A, B)
    # which of the A rows (A,) and of the B columns (B,) of points lie along creases or borders
    creases: tuple[Booleans, Booleans]
    strides: tuple[int, int]  # only every so many-th row and column of creases is among them


def measure_points(points: Array, surface: AskedSurface, samples: int = 20_000) -> Array:
    """Signed distances (...) of points (..., 3) from a surface, as exact as its mesh is fine.

    Parameters
    ----------
    points
        The points (..., 3).
    samples
        How fine the mesh is: as for so many samples of the surface.
    """
    mesh, _ = mesh_surface(surface, samples)
    found = mesh.nearest(points)
    return np.asarray(found.sides * found.distances)


def measure_signed(shell: Array, surface: AskedSurface, samples: int, most: int) -> SignedDistances:
    """Return signed distances of points of a shell's panels from a surface, for a picture.

    Parameters
    ----------
    shell
        Vertices (rows, columns, 3) of plane panels.
    samples
        Number of points, about.
    most
        Rows and columns of panels at most: of a finer shell every k-th is taken, k odd so that
        ridges and valleys still alternate.
    """
    (down, i), (right, j) = (_thinned(count, most) for count in shell.shape[:2])
    patch = Patch.of_shell(shell[np.ix_(i, j)], samples, longer=1.0)
    mesh, _ = mesh_surface(surface, samples)
    found = mesh.nearest(patch.points)
    return SignedDistances(
        points=patch.points,
        distances=found.sides * found.distances,
        creases=(patch.u == np.rint(patch.u), patch.v == np.rint(patch.v)),
        strides=(down, right),
    )


def _thinned(count: int, most: int) -> tuple[int, Integers]:
    """A stride, and the lines that are kept: both borders, and lines a stride apart between."""
    stride = max(1, -(-(count - 1) // most))
    stride += 1 - stride % 2
    kept = np.concatenate([[0], np.arange(1, count - 1, stride), [count - 2, count - 1]])
    return stride, np.unique(np.clip(kept, 0, count - 1))
