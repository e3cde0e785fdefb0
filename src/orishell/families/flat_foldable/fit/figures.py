"""How near a fitted shell is to its piece: what decides, not the sum of squares."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.design.piece import Piece
from orishell.families.flat_foldable.fit.residuals import Fitted
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_largest

SHARES = 5
"""Points along both sides of a panel that are measured."""
BACK = 20_000
"""About so many points of the piece are measured."""


@record
class Reached:
    """Distances of a shell and its piece, by the diagonal of the piece's box."""

    vertices: float  # of vertices from the offset surfaces, the largest
    rms: float  # the same, root mean square
    worst: tuple[int, int]  # the vertex that is farthest from them
    shell: float  # of points of the shell from the piece, the largest sampled
    back: float  # of points of the piece from the shell, the largest sampled
    offset: float  # of the offset surfaces from the piece

    @property
    def mesh(self) -> float:
        """The largest distance both ways."""
        return max(self.shell, self.back)

    @property
    def figures(self) -> tuple[float, float, float, float]:
        """Those by which sheets are compared."""
        return self.rms, self.vertices, self.shell, self.back

    def score(self, share: float = 1.0) -> float:
        """What decides between starts, the less the better.

        The distance of vertices, and that of the shell with its corrugation if panels were so many
        times smaller.
        """
        return self.vertices + self.mesh / share


def measure(piece: Piece, fitted: Fitted, size: float, offset: float) -> Reached:
    """Measure a shell whose offset is given (in units of the size)."""
    off = np.abs(fitted.heights) * size / piece.diagonal
    worst = np.unravel_index(first_largest(off), off.shape)
    points = within_panels(fitted.placed.vertices)
    shell = np.abs(piece.nearest(points)[0]).max()
    step = max(1, len(piece.vertices) // BACK)
    back = _distances(fitted.placed.vertices, piece.vertices[::step])
    return Reached(
        float(off.max()),
        float(np.sqrt((off**2).mean())),
        (int(worst[0]), int(worst[1])),
        float(shell / piece.diagonal),
        float(back.max() / piece.diagonal),
        offset * size / piece.diagonal,
    )


def within_panels(vertices: Array) -> Array:
    """Points (N, 3) spread over all panels, their edges included."""
    share = np.linspace(0, 1, SHARES)
    u, v = (each.ravel()[:, None, None, None] for each in np.meshgrid(share, share))
    above = vertices[:-1, :-1] * (1 - u) + vertices[:-1, 1:] * u
    below = vertices[1:, :-1] * (1 - u) + vertices[1:, 1:] * u
    return np.asarray(above * (1 - v) + below * v).reshape(-1, 3)


def _distances(vertices: Array, points: Array) -> Array:
    """Distances (N,) of points (N, 3) from the panels between vertices (R+2, C+2, 3)."""
    import igl

    rows, columns = vertices.shape[:2]
    number = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    triangles = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    corners = np.ascontiguousarray(vertices.reshape(-1, 3))
    tree = igl.AABB()
    tree.init(corners, triangles)
    _, _, feet = tree.squared_distance(corners, triangles, np.ascontiguousarray(points))
    return lengths(points - feet)
