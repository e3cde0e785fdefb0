"""What is loaded, and how it stands."""

from __future__ import annotations

import numpy as np

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

    mesh: Facets  # nodes (N, 3) and triangles (T, 3), all panels' cells one way round
    panels: Integers  # the panel (T,) of every triangle, as the grid counts it
    grid: Grid  # the grid of the sheet between its flaps; its vertices are the first nodes
    # number of columns of folded flaps before its first column, which points are counted with
    before: int
    areal_mass: Array  # mass (T,) per area of every triangle (kg per square of the unit)
    hung: Array  # mass (N,) of flaps that hang on nodes (kg)
    unit: str  # the design's unit of length
    ground: float  # height of the ground (length)
    span: float | None  # from foot to foot; None if it does not stand on two feet (length)

    @property
    def rise(self) -> float:
        """Height of its top over the ground (length)."""
        return float(self.mesh.points[:, 2].max()) - self.ground

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
