"""How close whole boards are to what the vertices of their sheet would follow.

Boards do not meet at vertices. Where vertices follow f or g, the edges of boards beside them do;
where these lie on surfaces beside the one asked for, corners of boards do. All are taken half way
up the boards.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from orishell.conventions.record import record
from orishell.curves.nearest import Closeness
from orishell.design import AskedSurface, Design
from orishell.deviation.triangles import Patch, mesh_surface
from orishell.motion.hinges import Hinges
from orishell.motion.quads import lengths
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


PER_EDGE = 16
"""Points on every edge of a board."""
ALONG = 4000
"""Points on a curve, about."""


def boards_closeness(design: Design) -> Mapping[str, Closeness]:
    """Distances of boards at the target from f and g, or from surfaces beside the one asked for.

    By the names of ``design.closeness``, where that has them. Distances from f are those of the
    boards beside column 1, distances from g those of the boards on both sides of the middle row.
    """
    hinges, meant, mechanism = design.hinges, design.meant, design.mechanism
    assert isinstance(hinges, Hinges)
    assert meant is not None
    boards = hinges.boards(mechanism.positions(mechanism.target_drive))
    middle = mechanism.grid.rows // 2
    # Corners of a panel: left above, left below, right below, right above.
    edges = {
        "f": boards[:, 0, [0, 1]],
        "g": np.concatenate([boards[middle - 1][:, [1, 2]], boards[middle][:, [0, 3]]]),
    }
    found = {
        name: _along(curve, edges[name]) for name, curve in design.targets.items() if name in edges
    }
    if design.offset is not None and {"crests", "valleys"} <= set(design.closeness):
        found |= _beside(design, boards, meant, design.offset)
    return found


def _along(curve: Array, edges: Array) -> Closeness:
    """Distances between a curve (N, 3) and edges (E, 2, 3), both ways."""
    from scipy.spatial import cKDTree

    share = np.linspace(0.0, 1.0, PER_EDGE + 1)[:, None, None]
    points = (edges[:, 0] * (1 - share) + edges[:, 1] * share).reshape(-1, 3)
    near = np.asarray(cKDTree(curve).query(points)[1])
    sides = np.clip(near[:, None] + np.array([-1, 0]), 0, len(curve) - 2)
    ends = np.stack([curve[sides], curve[sides + 1]], axis=-2)
    from_edges = _from_segments(points[:, None], ends).min(axis=1)
    step = max(1, len(curve) // ALONG)
    kept = np.append(curve[:-1:step], curve[-1:], axis=0)
    from_curve = np.array([_from_segments(point, edges).min() for point in kept])
    pieces, squares = lengths(np.diff(kept, axis=0)), from_curve**2
    mean = float((0.5 * (squares[1:] + squares[:-1]) * pieces).sum() / pieces.sum())
    return Closeness(float(max(from_edges.max(), from_curve.max())), float(np.sqrt(mean)))


def _from_segments(points: Array, segments: Array) -> Array:
    """Distances (...) of points (..., 3) from segments (..., 2, 3)."""
    start, span = segments[..., 0, :], segments[..., 1, :] - segments[..., 0, :]
    away = points - start
    share = (away * span).sum(axis=-1) / (span * span).sum(axis=-1)
    return lengths(away - np.clip(share, 0.0, 1.0)[..., None] * span)


def _beside(design: Design, boards: Array, meant: Array, offset: float) -> dict[str, Closeness]:
    """Distances of corners of boards from the surfaces on which crests and valleys should lie."""
    heights = measure_points(boards, design.surface)
    above = measure_points(meant, design.surface).mean(axis=1) > 0
    upper, lower = heights[..., [0, 3]], heights[..., [1, 2]]
    found = {}
    for name, side in (("crests", True), ("valleys", False)):
        here = np.concatenate([upper[above[:-1] == side], lower[above[1:] == side]])
        off = np.abs(here - (offset if side else -offset))
        found[name] = Closeness(float(off.max()), float(np.sqrt((off**2).mean())))
    return found
