"""Two plates of 1 x 4 m that lean on each other at 30 degrees, against other people's programs.

20 mm, E 10 GPa, nu 0.3, 600 kg/m3. The ridge is level. Gables are held in their own planes: up and
sideways, one end of the ridge also along it. 1 kPa on plan. OpenSees, PyNite and CalculiX (S8R) had
8 x 32 cells on each plate; CalculiX still rises with finer ones, from 10.56 to 10.64 mm.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from scipy.sparse import csr_array, diags_array

from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array
from orishell.structure.mesh.geometric import geometric_stiffness
from orishell.structure.mesh.hinges import hinge_elements, rigid_stiffness
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import mesh_sheet
from orishell.structure.mesh.stresses import facet_stresses
from orishell.structure.solve.active_set import respond
from orishell.structure.solve.conditions import joined, on_ground
from orishell.structure.solve.factorise import factorise
from orishell.structure.solve.stability import (
    Inverse,
    find_buckling,
    find_frequencies,
)

SLOPE, LENGTH = np.deg2rad(30), 4.0
SECTION = Section.solid(10e9, 0.02, 0.3)
AREAL_MASS, PRESSURE = 600 * 0.02, 1000.0
GRID = Grid(2, 3)
RIGID = np.inf


@dataclass(frozen=True)
class Found:
    """Largest deflection (mm), frequencies (Hz) and buckling factor."""

    deflection: float
    frequencies: Array
    buckling: float


def plates(crease: float, cells: int) -> Found:
    x, y = np.meshgrid([-1.0, 0.0, 1.0], [LENGTH, 0.0])
    positions = np.stack([x * np.cos(SLOPE), y, -np.abs(x) * np.sin(SLOPE)], axis=-1)
    mesh = mesh_sheet(positions, GRID, cells)
    facets, own = mesh.facets, mesh.translations()
    elements = [mesh.elements(SECTION)]
    springs = min(crease, rigid_stiffness(mesh, SECTION))
    elements.append(hinge_elements(mesh, GRID, springs))
    area = np.zeros(len(facets.points))
    np.add.at(area, facets.triangles, facets.areas()[:, None] / 3)
    loads, mass = np.zeros(mesh.count), np.zeros(mesh.count)
    loads[own[:, 2]] = -PRESSURE * area * np.cos(SLOPE)
    mass[own] = AREAL_MASS * area[:, None]

    gables = np.isin(facets.points[:, 1], [0.0, LENGTH])
    supported = np.append(own[gables][:, [0, 2]], own[GRID.vertices()[0, 1], 1])
    nothing = joined([on_ground(np.zeros(0, np.int64), np.zeros(0))])
    held = factorise(elements, mesh, supported, nothing, GRID)
    found = respond(held, loads[held.free])
    moved = np.zeros(mesh.count)
    moved[held.free] = found.displacements
    inverse = Inverse.of(held, found.active, found.motions)
    forces = facet_stresses(facets, SECTION, moved[mesh.dofs()]).forces
    others = csr_array((mesh.count, mesh.count))
    turned = geometric_stiffness(mesh, forces, np.zeros(0, np.int64), held.free, others)
    buckling, _ = find_buckling(inverse, turned.times, 1)
    heavy = csr_array(diags_array(mass[held.free]))
    frequencies, _ = find_frequencies(inverse, heavy, 3)
    return Found(float(-1e3 * moved[own[:, 2]].min()), frequencies, buckling[0])


def test_rigid_crease() -> None:
    found = plates(RIGID, 16)
    assert found.deflection == pytest.approx(10.78, rel=1e-2)
    assert found.frequencies[0] == pytest.approx(6.73, rel=1e-2)
    assert found.buckling == pytest.approx(77.8, rel=1e-2)


@pytest.mark.parametrize(("crease", "reference"), [(1e4, 20.95), (100.0, 55.0), (0.0, 56.5)])
def test_hinges(crease: float, reference: float) -> None:
    """Springs of N m/rad per metre move the deflection five times."""
    assert plates(crease, 16).deflection == pytest.approx(reference, rel=5e-3)
