"""Masses of a meshed shell."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.numerics.arrays import Array
from orishell.structure.loads import Exposure
from orishell.structure.mesh.sheet import SheetMesh, points_by_dofs

if TYPE_CHECKING:
    from scipy.sparse import csr_array


def point_masses(exposure: Exposure) -> Array:
    """Mass (N,) at every point (kg)."""
    share = exposure.areal_mass * exposure.mesh.areas() / 3
    lumped = exposure.hung.copy()
    np.add.at(lumped, exposure.mesh.triangles, share[:, None])
    return lumped


def inertia(mesh: SheetMesh, masses: Array, metres: float) -> csr_array:
    """Forces by accelerations (D, D) of dofs, the latter in a unit of so many metres.

    masses: At every point (N,) (kg).
    """
    from scipy.sparse import csr_array, diags_array

    by_dofs = points_by_dofs(mesh)
    return csr_array(by_dofs.T @ (diags_array(np.repeat(metres * masses, 3)) @ by_dofs))
