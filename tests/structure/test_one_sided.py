"""Ties, flaps and the ground against what statics says of them."""

from __future__ import annotations

import numpy as np
import pytest

from orishell.motion.grid import Grid
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import SheetMesh, mesh_sheet
from orishell.structure.solve.active_set import Response, respond
from orishell.structure.solve.conditions import Conditions, between, joined, on_ground
from orishell.structure.solve.contact_path import smoothly, solve
from orishell.structure.solve.factorise import factorise
from orishell.structure.solve.factorised import Factorised
from orishell.structure.solve.friction import Contact

GRID, SECTION = Grid(2, 2), Section.solid(1e9, 0.02, 0.3)
CORNERS = np.array([0, 1, 2, 3])
WEIGHT, FRICTION = 100.0, 0.4


def slab(conditions: list[Conditions]) -> tuple[SheetMesh, Factorised]:
    """A square panel of 1 m that lies on what conditions are."""
    x, y = np.meshgrid([0.0, 1.0], [1.0, 0.0])
    mesh = mesh_sheet(np.stack([x, y, 0 * x], axis=-1), GRID, 2)
    elements = [mesh.elements(SECTION)]
    return mesh, factorise(elements, mesh, np.zeros(0, np.int64), joined(conditions), GRID)


def load(
    mesh: SheetMesh, held: Factorised, *forces: tuple[int, tuple[float, float, float]]
) -> Response:
    """What forces at nodes do, beside weight that is spread over all nodes."""
    loads = np.zeros(mesh.count)
    at = mesh.translations()
    loads[at[:, 2]] -= WEIGHT / len(at)
    for node, force in forces:
        loads[at[node]] += force
    return respond(held, loads[held.free])


def middle(mesh: SheetMesh) -> int:
    return int(np.argmin(np.linalg.norm(mesh.facets.points - [0.5, 0.5, 0], axis=1)))


@pytest.mark.parametrize("way", [0.0, 0.3, 1.2])
def test_a_slab_sticks_until_friction_is_used_up(way: float) -> None:
    """Pushed aside in its middle by 0.9 and by 1.1 of mu N."""
    mesh, held = slab([on_ground(CORNERS, np.full(4, FRICTION))])
    along = FRICTION * WEIGHT * np.array([np.cos(way), np.sin(way), 0.0])
    sticks = load(mesh, held, (middle(mesh), tuple(0.9 * along)))
    assert sticks.moves is None
    presses, rubs = sticks.forces[:4], sticks.forces[4:12].reshape(-1, 2)
    assert presses.sum() == pytest.approx(WEIGHT, rel=1e-9)
    np.testing.assert_allclose(rubs.sum(axis=0), 0.9 * along[:2], atol=1e-7 * WEIGHT)
    slips = load(mesh, held, (middle(mesh), tuple(1.1 * along)))
    assert slips.moves is not None
    moved = np.zeros(mesh.count)
    moved[held.free] = slips.moves
    assert (moved[mesh.translations()] @ along > 0).all()


def test_the_ground_does_not_pull() -> None:
    """Lifted at a corner by a fifth of its weight: the feet across bear what moments ask for."""
    mesh, held = slab([on_ground(CORNERS, np.zeros(4))])
    found = load(mesh, held, (0, (0.0, 0.0, 0.2 * WEIGHT)))
    assert found.moves is None
    bears = found.forces[:4]
    assert (bears >= 0).all()
    assert bears.sum() == pytest.approx(0.8 * WEIGHT, rel=1e-9)
    places = mesh.facets.points[CORNERS]
    moments = bears @ places
    expected = 1.0 * WEIGHT * np.array([0.5, 0.5, 0.0]) - 0.2 * WEIGHT * places[0]
    np.testing.assert_allclose(moments, expected, atol=1e-8 * WEIGHT)
    assert load(mesh, held, (0, (0.0, 0.0, 0.6 * WEIGHT))).moves is not None


def test_without_friction_there_is_one_answer() -> None:
    """Pressed in its middle, on four feet: wherever Newton's method begins, it ends there or not.

    Less and less smooth cones, which need no good start, end there, too.
    """
    mesh, held = slab([on_ground(CORNERS, np.zeros(4))])
    loads = np.zeros(mesh.count)
    loads[mesh.translations()[middle(mesh), 2]] = -WEIGHT
    contact = Contact.of(held, held.spring_solve(loads[held.free]))
    known, right = solve(contact, contact.opened, 1.0)
    assert right
    size = float(np.abs(known).max())
    starts = np.random.default_rng(2).normal(0, size, (20, len(known)))
    ends = [y for y, ended in (solve(contact, start, 1.0) for start in starts) if ended]
    assert len(ends) > 1
    smooth = smoothly(contact, 1.0)
    assert smooth is not None
    forces = contact.at(known, 1.0).forces  # y is loose where the slab slides freely
    for found in (*ends, smooth):
        np.testing.assert_allclose(contact.at(found, 1.0).forces, forces, atol=1e-8 * size)


@pytest.mark.parametrize(("approach", "sign"), [(False, 1.0), (True, -1.0)])
@pytest.mark.parametrize("stiffness", [np.inf, 5e4])
def test_a_tie_pulls_and_a_flap_presses(approach: bool, sign: float, stiffness: float) -> None:
    """One side held, the other pulled along x by 7 N through a tie to the first: 7 N or none."""
    grid = Grid(2, 3)
    x, y = np.meshgrid([0.0, 1.0, 2.0], [1.0, 0.0])
    mesh = mesh_sheet(np.stack([x, y, 0 * x], axis=-1), grid, 2)
    own = mesh.translations()
    vertices = grid.vertices()
    # Panels that are not joined to each other: no more than springs of 1 N/m in their planes.
    pair = np.array([[vertices[0, 0], vertices[0, 2]], [vertices[1, 0], vertices[1, 2]]])
    ties = between(mesh.facets.points, pair, np.full(2, stiffness), approach=approach)
    section = Section.solid(1e3, 1e-3, 0.3)
    elements = [mesh.elements(section)]
    left = mesh.facets.points[:, 0] == 0
    held_up = np.concatenate([own[:, 2], own[left].ravel(), mesh.rotations()[..., :2].ravel()])
    held = factorise(elements, mesh, np.unique(held_up), ties, grid)
    for way in (1.0, -1.0):
        loads = np.zeros(mesh.count)
        loads[own[[vertices[0, 2], vertices[1, 2]], 0]] = 3.5 * way
        found = respond(held, loads[held.free])
        share = 1e6 if np.isinf(stiffness) else stiffness
        expected = 3.5 if way == sign else 0.0
        np.testing.assert_allclose(found.forces[:2], expected, rtol=2.0 / share * 1e3, atol=1e-9)
