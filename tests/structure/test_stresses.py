"""Stresses and moments of creases against beams and bars."""

from __future__ import annotations

import numpy as np
import pytest

from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array
from orishell.structure.mesh.hinges import crease_moments, hinge_elements, rigid_stiffness
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import SheetMesh, mesh_sheet
from orishell.structure.mesh.stresses import FacetStresses, facet_stresses
from orishell.structure.solve.active_set import respond
from orishell.structure.solve.conditions import joined, on_ground
from orishell.structure.solve.factorise import factorise

LONG, WIDE, THICK = 1.0, 0.25, 0.01
SECTION, GRID = Section.solid(1e9, THICK, 0.0), Grid(2, 3)
NOTHING = joined([on_ground(np.zeros(0, np.int64), np.zeros(0))])


def strip(force: tuple[float, float, float], crease: float = np.inf) -> tuple[SheetMesh, Array]:
    """Two panels in line, clamped at x = 0, under a force that is spread over the other end."""
    x, y = np.meshgrid([0.0, 0.5 * LONG, LONG], [WIDE, 0.0])
    mesh = mesh_sheet(np.stack([x, y, 0 * x], axis=-1), GRID, 8)
    own, points = mesh.translations(), mesh.facets.points
    root, end = (points[:, 0] == place for place in (0.0, LONG))
    turned = mesh.rotations()[np.isin(mesh.nodes, np.flatnonzero(root))]
    supported = np.unique(np.concatenate([own[root].ravel(), turned.ravel()]))
    elements = [mesh.elements(SECTION)]
    springs = min(crease, rigid_stiffness(mesh, SECTION))
    elements.append(hinge_elements(mesh, GRID, springs))
    held = factorise(elements, mesh, supported, NOTHING, GRID)
    share = np.where((points[:, 1] == 0) | (points[:, 1] == WIDE), 0.5, 1.0) * end
    loads = np.zeros(mesh.count)
    loads[own] = share[:, None] / share.sum() * np.array(force)
    moved = np.zeros(mesh.count)
    moved[held.free] = respond(held, loads[held.free]).displacements
    return mesh, moved


def stresses(mesh: SheetMesh, moved: Array) -> tuple[FacetStresses, Array]:
    middles = mesh.facets.points[mesh.facets.triangles].mean(axis=1)
    return facet_stresses(mesh.facets, SECTION, moved[mesh.dofs()]), middles


def test_bending_of_a_cantilever() -> None:
    """6 F (L - x)/(b t^2): a force upwards pulls at the lower face and presses on the upper one."""
    mesh, moved = strip((0.0, 0.0, 1.0))
    found, middles = stresses(mesh, moved)
    expected = 6 * (LONG - middles[:, 0]) / (WIDE * THICK**2)
    away = (middles[:, 0] > 0.1) & (middles[:, 0] < 0.9)
    lower, upper = found.principal().T
    near = 0.01 * expected.max()
    np.testing.assert_allclose(lower[away], expected[away], atol=near)
    np.testing.assert_allclose(upper[away], -expected[away], atol=near)
    both = np.stack([expected, expected], axis=1)
    np.testing.assert_allclose(found.von_mises()[away], both[away], atol=near)
    along = mesh.facets.axes()[:, 0]
    sign = np.einsum("tfc,tc->tf", found.faces[..., :2], along[:, :2] ** 2)
    assert (sign[away, 0] > 0).all()
    assert (sign[away, 1] < 0).all()


def test_pull_along_a_bar() -> None:
    """F/(b t) in both faces."""
    mesh, moved = strip((5.0, 0.0, 0.0))
    found, middles = stresses(mesh, moved)
    away = middles[:, 0] < 0.25  # from the crease, which passes on no moments in the plane
    np.testing.assert_allclose(found.von_mises()[away], 5.0 / (WIDE * THICK), rtol=0.01)


@pytest.mark.parametrize("crease", [np.inf, 3.0, 0.2])
def test_moment_of_a_crease(crease: float) -> None:
    """F L/2 over the width b, however stiff it is; the end goes down by F (L/2)^2/(k b) more."""
    mesh, moved = strip((0.0, 0.0, 1.0), crease)
    found = crease_moments(mesh, GRID, SECTION, moved)
    assert np.count_nonzero(found) == 1
    assert found.max() == pytest.approx(0.5 * LONG / WIDE, rel=0.02)
    bending = 1e9 * THICK**3 / 12 * WIDE
    expected = LONG**3 / (3 * bending)
    if np.isfinite(crease):
        expected += (0.5 * LONG) ** 2 / (crease * WIDE)
    lift = moved[mesh.translations()][mesh.facets.points[:, 0] == LONG, 2]
    np.testing.assert_allclose(lift, expected, rtol=0.01)
