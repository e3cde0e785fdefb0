"""A meshed shell as loads see it."""

from __future__ import annotations

from orishell.conventions.record import record
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.facets import Facets


@record
class Exposure:
    """What is loaded, and how it stands.

    Parameters
    ----------
    mesh
        Nodes (N, 3) and triangles (T, 3), all panels' cells one way round.
    panels
        The panel (T,) of every triangle, as the grid counts it.
    grid
        The grid of the sheet between its flaps; its vertices are the first nodes.
    before
        Number of columns of folded flaps before its first column, which points are counted with.
    areal_mass
        Mass (T,) per area of every triangle (kg per square of the unit).
    hung
        Mass (N,) of flaps that hang on nodes (kg).
    unit
        The design's unit of length.
    ground
        Height of the ground (length).
    span
        From foot to foot; None if it does not stand on two feet (length).
    """

    mesh: Facets
    panels: Integers
    grid: Grid
    before: int
    areal_mass: Array
    hung: Array
    unit: str
    ground: float
    span: float | None

    @property
    def rise(self) -> float:
        """Height of its top over the ground (length)."""
        return float(self.mesh.points[:, 2].max()) - self.ground

    def outer(self) -> Array:
        """Unit normals (T, 3) of the outer face: that which looks up, all panels together."""
        normals = self.mesh.axes()[:, 2]
        up = float(self.mesh.areas() @ normals[:, 2])
        return -normals if up < 0 else normals
