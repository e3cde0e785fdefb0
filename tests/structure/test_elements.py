"""Facets against the benchmarks of shell elements, and the hinged sheet's free motions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
import pytest
from scipy.sparse.linalg import spsolve

from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.hinges import hinge_elements
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import mesh_sheet
from orishell.structure.mesh.triangle import DOFS, Facets

EXAMPLES = Path(__file__).parents[2] / "examples"


def lattice(
    rows: int, columns: int, place: Callable[[Array, Array], list[Array]]
) -> tuple[Facets, Integers]:
    u, v = np.meshgrid(np.linspace(0, 1, rows + 1), np.linspace(0, 1, columns + 1), indexing="ij")
    nodes = np.arange(u.size).reshape(u.shape)
    a, b, c, d = nodes[:-1, :-1], nodes[1:, :-1], nodes[1:, 1:], nodes[:-1, 1:]
    triangles = [np.stack(each, axis=-1).reshape(-1, 3) for each in ((a, b, c), (a, c, d))]
    points = np.stack(place(u, v), axis=-1).reshape(-1, 3)
    return Facets(points, np.concatenate(triangles)), nodes


@pytest.mark.parametrize("turned", [0.0, 1e3])
def test_forces_balance_however_far_a_sheet_is_turned(turned: float) -> None:
    """Those of elements, on the whole, and they are what the assembled matrix says."""
    grid = Grid(3, 3)
    mesh = mesh_sheet(np.random.default_rng(2).normal(size=(3, 3, 3)), grid, 2)
    elements = [mesh.elements(Section.solid(1e9, 0.01, 0.3)), hinge_elements(mesh, grid, 20.0)]
    points, own, turns = mesh.facets.points, mesh.translations(), mesh.rotations().reshape(-1, 3)
    strained = 1e-3 * np.random.default_rng(3).normal(size=mesh.count)
    whole = np.zeros(mesh.count)
    whole[own], whole[turns] = np.cross([0.0, 0.0, turned], points), [0.0, 0.0, turned]
    total = np.sum([each.total(strained + whole) for each in elements], axis=0)
    size = np.abs(total).sum()
    missing = np.cross(points, total[own]).sum(axis=0) + total[turns].sum(axis=0)
    assert np.abs(total[own].sum(axis=0)).max() < 1e-14 * size
    assert np.abs(missing).max() < 1e-14 * size
    expected = np.sum([each.assembled() @ strained for each in elements], axis=0)
    np.testing.assert_allclose(total, expected, atol=1e-12 * max(turned, 1.0) * size)


def solve(
    facets: Facets, section: Section, load: Array, fixed: Sequence[tuple[Integers, Sequence[int]]]
) -> Array:
    """Displacements and rotations (N, 6)."""
    count = DOFS * len(facets.points)
    stiffness = facets.elements(section, facets.dofs(), count).assembled()
    held = [DOFS * nodes.ravel() + k for nodes, which in fixed for k in which]
    free = np.setdiff1d(np.arange(count), np.concatenate(held))
    found = np.zeros(count)
    found[free] = spsolve(stiffness[free][:, free].tocsc(), load.ravel()[free])
    return found.reshape(-1, DOFS)


def spread(facets: Facets, pressure: Sequence[float]) -> Array:
    load = np.zeros((len(facets.points), DOFS))
    for corner in facets.triangles.T:
        np.add.at(load[:, :3], corner, facets.areas()[:, None] / 3 * np.array(pressure))
    return load


def test_a_simply_supported_square_plate() -> None:
    """0.00406 q a^4 / D in the middle (Timoshenko), from below as the mesh becomes finer."""
    facets, nodes = lattice(16, 16, lambda u, v: [u, v, 0 * u])
    section = Section.solid(1e7, 0.01, 0.3)
    rim = np.concatenate([nodes[0], nodes[-1], nodes[:, 0], nodes[:, -1]])
    held = [(rim, (2,)), (nodes, (0, 1, 5))]
    found = solve(facets, section, spread(facets, [0, 0, -1]), held)
    assert -found[nodes[8, 8], 2] * section.bending == pytest.approx(0.00406, rel=3e-3)


def test_scordelis_lo_roof() -> None:
    """0.3024 at the middle of the free edge (MacNeal and Harder 1985)."""
    turn = np.deg2rad(40)
    facets, nodes = lattice(
        16, 16, lambda u, v: [25 * np.sin(turn * u), 25 * v, 25 * np.cos(turn * u)]
    )
    held = [(nodes[:, 0], (0, 2)), (nodes[:, -1], (1, 3, 5)), (nodes[0], (0, 4, 5))]
    load = spread(facets, [0, 0, -90])
    found = solve(facets, Section.solid(4.32e8, 0.25, 0.0), load, held)
    assert -found[nodes[16, 16], 2] == pytest.approx(0.3024, rel=5e-3)


def test_pinched_cylinder() -> None:
    """1.8248e-5 under a point load of 1, an eighth of the cylinder."""
    facets, nodes = lattice(
        32, 32, lambda u, v: [300 * np.sin(np.pi / 2 * u), 300 * v, 300 * np.cos(np.pi / 2 * u)]
    )
    held = [
        (nodes[:, 0], (0, 2)),
        (nodes[:, -1], (1, 3, 5)),
        (nodes[0], (0, 4, 5)),
        (nodes[-1], (2, 3, 4)),
    ]
    load = np.zeros((len(facets.points), DOFS))
    load[nodes[0, -1], 2] = -0.25
    found = solve(facets, Section.solid(3e6, 3, 0.3), load, held)
    assert -found[nodes[0, -1], 2] == pytest.approx(1.8248e-5, rel=2e-2)


@pytest.mark.parametrize(("axis", "reference"), [(2, 5.424e-3), (1, 1.754e-3)])
def test_twisted_beam(axis: int, reference: float) -> None:
    """Loads of 1 at its end, in plane and out of it (MacNeal and Harder 1985)."""
    facets, nodes = lattice(
        24,
        4,
        lambda u, v: [
            12 * u,
            1.1 * (v - 0.5) * np.cos(np.pi / 2 * u),
            1.1 * (v - 0.5) * np.sin(np.pi / 2 * u),
        ],
    )
    load = np.zeros((len(facets.points), DOFS))
    load[nodes[-1], axis] = np.array([0.125, 0.25, 0.25, 0.25, 0.125])
    found = solve(facets, Section.solid(29e6, 0.32, 0.22), load, [(nodes[0], range(6))])
    assert found[nodes[-1, 2], axis] == pytest.approx(reference, rel=1e-2)
