"""Flat triangles in space: stiffness of membrane and bending.

Every node has six freedoms, three translations and three rotations, in the world's axes.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.structure.elements import Elements
from orishell.structure.membrane import membrane_stiffness
from orishell.structure.plate import plate_stiffness
from orishell.structure.sections import Section

FREEDOMS = 6
IN_PLANE, OUT_OF_PLANE = (0, 1, 5), (2, 3, 4)
"""Freedoms of a node in its triangle's axes: u, v, rotation about z; w, rotations about x and y."""


@record
class Facets:
    """Triangles in space.

    Parameters
    ----------
    points
        Nodes (N, 3).
    triangles
        Corners (T, 3).
    """

    points: Array
    triangles: Integers

    def axes(self) -> Array:
        """Axes (T, 3, 3) of every triangle, as rows: along its first side, in its plane, normal."""
        corners = self.points[self.triangles]
        x = corners[:, 1] - corners[:, 0]
        z = np.cross(x, corners[:, 2] - corners[:, 0])
        x, z = (each / np.linalg.norm(each, axis=1, keepdims=True) for each in (x, z))
        return np.stack([x, np.cross(z, x), z], axis=1)

    def flat(self) -> Array:
        """Corners (T, 3, 2) of every triangle in its own axes, the first in the origin."""
        corners = self.points[self.triangles]
        away = corners - corners[:, :1]
        return np.asarray(np.einsum("tij,tkj->tki", self.axes(), away)[..., :2])

    def areas(self) -> Array:
        """Area (T,) of every triangle."""
        corners = self.points[self.triangles]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        return np.asarray(0.5 * np.linalg.norm(normal, axis=1))

    def element_stiffness(self, section: Section) -> Array:
        """Stiffness (T, 18, 18) of every triangle in the world's axes."""
        axes, flat = self.axes(), self.flat()
        local = np.zeros((len(flat), 18, 18))
        membrane = membrane_stiffness(flat, section.matrix(section.membrane), section.poisson)
        plate = plate_stiffness(flat, section.matrix(section.bending))
        for part, own in ((membrane, IN_PLANE), (plate, OUT_OF_PLANE)):
            places = (FREEDOMS * np.arange(3)[:, None] + np.array(own)).ravel()
            local[:, places[:, None], places] = part
        turned = np.zeros((len(flat), 18, 18))
        for k in range(6):
            turned[:, 3 * k : 3 * k + 3, 3 * k : 3 * k + 3] = axes
        return np.asarray(turned.swapaxes(1, 2) @ local @ turned)

    def elements(self, section: Section, freedoms: Integers, count: int) -> Elements:
        """The triangles as elements.

        Parameters
        ----------
        freedoms
            Freedoms (T, 18) of their corners: displacements, then rotations, of each.
        count
            Number of all freedoms.
        """
        corners = self.points[self.triangles]
        arms = corners[:, 1:] - corners[:, :1]
        return Elements(self.element_stiffness(section), freedoms, arms, count)

    def freedoms(self) -> Integers:
        """Freedoms (T, 18) of the corners of every triangle, where no node has rotations apart."""
        places = FREEDOMS * self.triangles[..., None] + np.arange(FREEDOMS)
        return np.asarray(places.reshape(-1, 18))
