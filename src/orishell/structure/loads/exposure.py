"""What is loaded, and how it stands."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.triangle import Facets

Vector = tuple[float, float, float]
UP = np.array([0.0, 0.0, 1.0])


def vector(values: Array) -> Vector:
    """Three numbers (3,) as files have them."""
    x, y, z = values.tolist()
    return x, y, z


@record
class Exposure:
    """What is loaded, and how it stands."""

    # nodes (N, 3), also of what stiffens panels and is not exposed itself, and triangles (T, 3) of
    # panels, all cells one way round
    mesh: Facets
    panels: Integers  # the panel (T,) of every triangle, as the grid counts it
    grid: Grid  # the grid of the sheet between its flaps; its vertices are the first nodes
    # number of columns of folded flaps before its first column, which points are counted with
    before: int
    areal_mass: Array  # mass (T,) per area of every triangle (kg per square of the unit)
    hung: Array  # mass (N,) of what hangs on nodes: flaps, gussets, box girders, base rails (kg)
    unit: str  # the design's unit of length
    ground: float  # height of the ground (length)
    span: float | None  # from foot to foot; None if it does not stand on two feet (length)
    feet: tuple[int, int] | None = None  # rows of vertices that it stands on; None likewise

    @property
    def rise(self) -> float:
        """Height of its top over the ground (length)."""
        return float(self.mesh.points[self.mesh.triangles, 2].max()) - self.ground

    @property
    def rows(self) -> Integers:
        """The row (T,) of panels of every triangle."""
        return np.asarray(self.panels // (self.grid.columns - 1))

    @property
    def columns(self) -> Integers:
        """The column (T,) of panels of every triangle."""
        return np.asarray(self.panels % (self.grid.columns - 1))

    def ridges(self) -> Array:
        """Middles (rows, columns, 3) of the edges that panels of a column share, row by row."""
        vertices = self.mesh.points[self.grid.vertices()]
        return np.asarray(0.5 * (vertices[:, :-1] + vertices[:, 1:]))

    def centroids(self) -> Array:
        """Middles (T, 3) of triangles."""
        return np.asarray(self.mesh.points[self.mesh.triangles].mean(axis=1))

    def across(self) -> tuple[Array, Array]:
        """Where triangles (T,) lie from the first foot, 0, to the second, 1, and which way that is.

        Both in plan, in each column of panels by its own feet; the ways (T, 2) are unit vectors.

        Raises InputError: If it does not stand on two feet.
        """
        if self.feet is None:
            raise InputError(
                "there are no feet, so there is no span",
                expected="a shell that stands on the two ends of f",
                remedy='shape = "valleys" of snow, zones of rows of wind',
            )
        first, second = self.ridges()[list(self.feet)][:, self.columns, :2]
        way = second - first
        length = np.linalg.norm(way, axis=1)
        share = ((self.centroids()[:, :2] - first) * way).sum(axis=1) / length**2
        return share, way / length[:, None]

    def outer(self) -> Array:
        """Unit normals (T, 3) of the outer face: that which looks up, all panels together."""
        normals = self.mesh.axes()[:, 2]
        up = float(self.mesh.areas() @ normals[:, 2])
        return -normals if up < 0 else normals

    def on_corners(self, per_area: Array) -> Array:
        """Loads (T, 3) per area of triangles as forces (N, 3) on nodes."""
        shared = np.zeros_like(self.mesh.points)
        each = (self.mesh.areas()[:, None] * per_area)[:, None] / 3
        np.add.at(shared, self.mesh.triangles, each)
        return shared
