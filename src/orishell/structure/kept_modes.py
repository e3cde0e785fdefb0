"""Modes that load cases of one structure have from each other."""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array
from orishell.numerics.equals import SOLVED, first_largest
from orishell.structure.masses import inertia, point_masses
from orishell.structure.mesh.geometric import Turned
from orishell.structure.model import Model
from orishell.structure.solve.stability import Inverse, find_buckling, find_frequencies

FREQUENCIES = 3
"""How many frequencies are found."""


class KeptModes:
    """Modes of load cases with one stiffness of creases."""

    def __init__(self) -> None:
        self._buckled: list[tuple[Array, Array]] = []  # loads (3 N,) by their size, and modes
        self._swinging: dict[bytes, tuple[Array, Array]] = {}

    def buckling(
        self, forces: Array, inverse: Inverse, turned: Turned, count: int
    ) -> tuple[Array, Array]:
        """Lowest buckling factors (k,) and their modes (n, k).

        They are sought from those of the case whose loads are the most alike, whatever their size.

        forces: Loads (N, 3) of the case.
        """
        loads = forces.ravel() / np.linalg.norm(forces)
        alike = np.array([loads @ others for others, _ in self._buckled])
        near = self._buckled[first_largest(alike, SOLVED)][1] if alike.size else None
        factors, modes = find_buckling(inverse, turned.times, count, near)
        self._buckled.append((loads, modes))
        return factors, modes

    def swinging(self, model: Model, inverse: Inverse) -> tuple[Array, Array]:
        """Frequencies (k,) and their modes (n, k), the same where the same rows act."""
        key = inverse.active.tobytes()
        if key not in self._swinging:
            masses, free = point_masses(model.exposure), inverse.structure.free
            mass = inertia(model.mesh, masses, model.site.metres)[free][:, free]
            self._swinging[key] = find_frequencies(inverse, mass, FREQUENCIES)
        return self._swinging[key]
