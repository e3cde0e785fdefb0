"""Stresses and moments of creases against beams and bars."""

from __future__ import annotations

import numpy as np
import pytest

from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.edge_forces import (
    ABOUT,
    ACROSS,
    IN_PLANE,
    NORMAL,
    crease_sides,
    find_edge_forces,
    on_creases,
)
from orishell.structure.mesh.hinges import hinge_elements, rigid_stiffness
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import SheetMesh, mesh_sheet
from orishell.structure.mesh.stresses import (
    FacetForces,
    PanelStresses,
    facet_stresses,
    panel_stresses,
)
from orishell.structure.solve.active_set import respond
from orishell.structure.solve.conditions import joined, on_ground
from orishell.structure.solve.factorise import factorise

LONG, WIDE, THICK = 1.0, 0.25, 0.01
PLATE = Section.solid(1e9, THICK, 0.3)
SECTION, GRID = Section.solid(1e9, THICK, 0.0), Grid(2, 3)
NOTHING = joined([on_ground(np.zeros(0, np.int64), np.zeros(0))])


def strip(
    force: tuple[float, float, float], crease: float = np.inf, section: Section = SECTION
) -> tuple[SheetMesh, Array]:
    """Two panels in line, clamped at x = 0, under a force that is spread over the other end."""
    x, y = np.meshgrid([0.0, 0.5 * LONG, LONG], [WIDE, 0.0])
    mesh = mesh_sheet(np.stack([x, y, 0 * x], axis=-1), GRID, 8, grading=0)
    own, points = mesh.translations(), mesh.facets.points
    root, end = (points[:, 0] == place for place in (0.0, LONG))
    turned = mesh.rotations()[np.isin(mesh.nodes, np.flatnonzero(root))]
    supported = np.unique(np.concatenate([own[root].ravel(), turned.ravel()]))
    elements = [mesh.elements(section)]
    springs = min(crease, rigid_stiffness(mesh, section))
    elements.append(hinge_elements(mesh, GRID, springs))
    held = factorise(elements, mesh, supported, NOTHING, GRID)
    share = np.where((points[:, 1] == 0) | (points[:, 1] == WIDE), 0.5, 1.0) * end
    loads = np.zeros(mesh.count)
    loads[own] = share[:, None] / share.sum() * np.array(force)
    moved = np.zeros(mesh.count)
    moved[held.free] = respond(held, loads[held.free]).displacements
    return mesh, moved


def stresses(mesh: SheetMesh, moved: Array, section: Section = SECTION) -> PanelStresses:
    return panel_stresses(mesh, section, facet_stresses(mesh.facets, section, moved[mesh.dofs()]))


def patch_middles(mesh: SheetMesh, patches: Integers) -> Array:
    """Along x, the middle (T) of the triangles of a triangle's patch, corners apart from others."""
    middles = mesh.facets.points[mesh.facets.triangles].mean(axis=1)[:, 0]
    return np.asarray((np.bincount(patches, middles) / np.bincount(patches))[patches])


def test_bending_of_a_cantilever() -> None:
    """6 F (L - x)/(b t^2): a force upwards pulls at the lower face and presses on the upper one.

    x is in the middle of a patch: at the root 1/16 of the length from the end, at the corners 1/8.
    """
    mesh, moved = strip((0.0, 0.0, 1.0))
    found = stresses(mesh, moved)
    x = patch_middles(mesh, found.patches)
    at_corner = np.isin(found.patches % 16, [0, 3, 12, 15])
    panel = np.floor(2 * x / LONG)
    x[at_corner] = 0.5 * (panel + np.where(2 * x - panel < 0.5, 0.25, 0.75))[at_corner]
    expected = 6 * (LONG - x) / (WIDE * THICK**2)
    near = 0.01 * expected.max()
    lower, upper = found.principal().T
    np.testing.assert_allclose(lower, expected, atol=near)
    np.testing.assert_allclose(upper, -expected, atol=near)
    np.testing.assert_allclose(found.von_mises(), np.stack([expected] * 2, axis=1), atol=near)
    root = 6 * (LONG * 15 / 16) / (WIDE * THICK**2)
    assert found.von_mises().max() == pytest.approx(root, rel=1e-2)


def test_pull_along_a_bar() -> None:
    """F/(b t) in both faces."""
    mesh, moved = strip((5.0, 0.0, 0.0))
    found = stresses(mesh, moved)
    away = patch_middles(mesh, found.patches) < 0.2  # from the crease: it passes on no moments
    np.testing.assert_allclose(found.von_mises()[away], 5.0 / (WIDE * THICK), rtol=0.01)


@pytest.mark.parametrize(("cells", "near"), [(6, 0.13), (24, 0.03)])
def test_shear_across_a_plate(cells: int, near: float) -> None:
    """Navier's series of a simply supported square plate, by patches at the middle of its sides.

    Cells are narrower at the sides; shear comes from above, 5 % too large with 6 of them.
    """
    x, y = np.meshgrid([0.0, 1.0], [1.0, 0.0])
    mesh = mesh_sheet(np.stack([x, y, 0 * x], axis=-1), Grid(2, 2), cells)
    own, turns = mesh.translations(), mesh.rotations().reshape(-1, 3)
    points = mesh.facets.points
    rim = ((points[:, :2] < 1e-9) | (points[:, :2] > 1 - 1e-9)).any(axis=1)
    supported = np.concatenate([own[rim, 2], own[:, :2].ravel(), turns[:, 2]])
    held = factorise([mesh.elements(PLATE)], mesh, supported, NOTHING, Grid(2, 2))
    loads = np.zeros(mesh.count)
    for corner in mesh.facets.triangles.T:
        np.add.at(loads, own[corner, 2], mesh.facets.areas() / 3)
    moved = np.zeros(mesh.count)
    moved[held.free] = respond(held, loads[held.free]).displacements
    borne = facet_stresses(mesh.facets, PLATE, moved[mesh.dofs()])
    across = THICK * panel_stresses(mesh, PLATE, borne).across.reshape(4, 4, 2)
    odd, along = np.arange(1, 160, 2), (np.arange(16) + 0.5) / 64
    p, q = odd[:, None], odd
    share = 16 / np.pi**3 / q / (p**2 + q**2)
    at_side = np.cos(np.pi * np.outer(along, odd)).mean(axis=0)
    beside = np.sin(np.pi * np.outer(along + 0.25, odd)).mean(axis=0)
    hand = float(at_side @ share @ beside)
    # The first axis is that of the side that goes down, the second goes to the right.
    assert np.abs(across[1, 0, 1]) == pytest.approx(hand, rel=near)
    assert np.abs(across[0, 1, 0]) == pytest.approx(hand, rel=near)
    assert np.abs(across[1:3, [0, 3], 1]) == pytest.approx(np.abs(across[1, 0, 1]), rel=1e-6)


@pytest.mark.parametrize("cells", [4, 5, 8])
def test_patches_of_a_linear_field(cells: int) -> None:
    """Their mean is its value in their middle where cells fit into patches, else it is near."""
    x, y = np.meshgrid([0.0, 2.0], [1.0, 0.0])
    mesh = mesh_sheet(np.stack([x + 0.3 * y, y, 0 * x], axis=-1), Grid(2, 2), cells, grading=0)
    middles = mesh.facets.points[mesh.facets.triangles].mean(axis=1)
    turn = mesh.facets.axes()[:, :2, :2]
    tensor = np.array([[3.0, 1.0], [1.0, -2.0]]) * (1 + middles @ [0.5, 2.0, 0.0])[:, None, None]
    own = turn @ tensor @ turn.swapaxes(1, 2)
    forces = np.stack([own[:, 0, 0], own[:, 1, 1], own[:, 0, 1]], axis=1)
    straight = FacetForces(forces, 0 * forces, np.zeros((len(forces), 3, 3)))
    found = panel_stresses(mesh, SECTION, straight)
    size = np.sqrt(9 + 6 + 4 + 3.0) / THICK
    place = (np.arange(4) + 0.5) / 4
    down, right = (each.ravel() for each in np.meshgrid(place, place, indexing="ij"))
    corners = [0, 3, 12, 15]
    down[corners], right[corners] = [0.25, 0.25, 0.75, 0.75], [0.25, 0.75, 0.25, 0.75]
    across, up = 2 * right + 0.3 * (1 - down), 1 - down
    expected = size * (1 + 0.5 * across + 2 * up)
    near = 1e-12 if cells % 4 == 0 else 0.05
    np.testing.assert_allclose(found.von_mises()[:, 0], expected[found.patches], rtol=near)


@pytest.mark.parametrize("crease", [np.inf, 3.0, 0.2])
def test_forces_of_a_crease(crease: float) -> None:
    """F L/2 over the width b, however stiff it is; the end goes down by F (L/2)^2/(k b) more.

    A force upwards and outwards at the end: the crease passes on both, and its moment stretches
    the lower face.
    """
    mesh, moved = strip((3.0, 0.0, 1.0), crease)
    nothing = np.zeros((mesh.nodes.size, 3))
    springs = hinge_elements(mesh, GRID, min(crease, rigid_stiffness(mesh, SECTION)))
    forces, turning = (each.forces(moved) for each in (mesh.elements(SECTION), springs))
    edges = find_edge_forces(mesh, GRID, forces, turning, nothing)
    (found,) = on_creases(edges.per_length, GRID)
    mean = found.mean(axis=1)
    np.testing.assert_allclose(mean[:, ABOUT], 0.5 * LONG / WIDE, rtol=1e-6)
    _, (sides,) = crease_sides(GRID)
    for (panel, edge), sign in zip(sides, (1, -1), strict=True):
        total = edges.resultants[panel, edge, :3]
        np.testing.assert_allclose(total, [sign * 3.0, 0, sign * 1.0], atol=1e-9)
    np.testing.assert_allclose(mean[:, NORMAL], 3.0 / WIDE, rtol=1e-6)
    np.testing.assert_allclose(mean[:, IN_PLANE], 0.0, atol=1e-6)
    np.testing.assert_allclose(mean[:, ACROSS], [1.0 / WIDE, -1.0 / WIDE], rtol=1e-6)
    bending = 1e9 * THICK**3 / 12 * WIDE
    expected = LONG**3 / (3 * bending)
    if np.isfinite(crease):
        expected += (0.5 * LONG) ** 2 / (crease * WIDE)
    lift = moved[mesh.translations()][mesh.facets.points[:, 0] == LONG, 2]
    np.testing.assert_allclose(lift, expected, rtol=0.01)
