"""Strains, forces and stresses of triangles under displacements."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.triangle import IN_PLANE, OUT_OF_PLANE, Facets, curvatures, strains

MIDDLE = 1 / 3, 1 / 3


@record
class FacetStresses:
    """What triangles bear, in their own axes."""

    forces: Array  # membrane forces xx, yy, xy (T, 3) (force per length)
    faces: Array  # stresses xx, yy, xy (T, 2, 3) at the lower and the upper face (force per area)

    def von_mises(self) -> Array:
        """Von Mises' stress (T, 2) at both faces."""
        x, y, xy = np.moveaxis(self.faces, -1, 0)
        return np.asarray(np.sqrt(x**2 - x * y + y**2 + 3 * xy**2))

    def principal(self) -> Array:
        """The largest and the least principal stress (T, 2), of both faces."""
        x, y, xy = np.moveaxis(self.faces, -1, 0)
        middle, radius = 0.5 * (x + y), np.hypot(0.5 * (x - y), xy)
        return np.stack([(middle + radius).max(axis=1), (middle - radius).min(axis=1)], axis=1)


def facet_stresses(facets: Facets, section: Section, moved: Array) -> FacetStresses:
    """What triangles bear.

    moved: Displacements and rotations (T, 18) of their corners.
    """
    flat = facets.flat()
    local = np.einsum("tij,tkj->tki", facets.axes(), moved.reshape(-1, 6, 3)).reshape(-1, 3, 6)
    stretch = np.einsum("tij,tj->ti", strains(flat), local[..., IN_PLANE].reshape(-1, 9))
    bend = np.einsum(
        "tij,tj->ti", curvatures(flat, MIDDLE), local[..., OUT_OF_PLANE].reshape(-1, 9)
    )
    reach = np.broadcast_to(np.asarray(section.reach), len(flat))[:, None] * bend
    plane = section.matrix(section.modulus / (1 - section.poisson**2))
    forces = np.einsum(
        "...ij,tj->ti" if np.ndim(section.membrane) == 0 else "tij,tj->ti",
        section.matrix(section.membrane),
        stretch,
    )
    faces = np.stack([stretch - reach, stretch + reach], axis=1) @ plane
    return FacetStresses(forces, faces)
