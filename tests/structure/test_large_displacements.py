"""Triangles that are moved far, against published paths of shells, and against exact solutions.

K. Y. Sze, X. H. Liu and S. H. Lo, "Popular benchmark problems for geometric nonlinear analysis of
shells", Finite Elements in Analysis and Design 40 (2004) 1551-1569. Their tables were read where
others keep them: MBDyn's tests/plates/sze2004 (*_ref.dat), Elmer's Shell_OpenHemisphere and
Shell_Cantilever tests, Project Chrono's shell benchmarks.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import pytest

from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.corotational import Corotational, Moved
from orishell.structure.mesh.hinges import Folds
from orishell.structure.mesh.rotations import exponentials, logarithms
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.triangle import DOFS, Facets
from orishell.structure.solve import path
from orishell.structure.solve.moving import Moving
from orishell.structure.solve.path import Point, settle, trace
from samples import led_by, thorough


def lattice(
    rows: int, columns: int, place: Callable[[Array, Array], list[Array]]
) -> tuple[Facets, Integers]:
    """Cells cut by one diagonal and the other in turn."""
    u, v = np.meshgrid(np.linspace(0, 1, rows + 1), np.linspace(0, 1, columns + 1), indexing="ij")
    nodes = np.arange(u.size).reshape(u.shape)
    a, b, c, d = nodes[:-1, :-1], nodes[1:, :-1], nodes[1:, 1:], nodes[:-1, 1:]
    even = (np.add.outer(np.arange(rows), np.arange(columns)) % 2 == 0)[..., None]
    first = np.where(even, np.stack([a, b, c], axis=-1), np.stack([a, b, d], axis=-1))
    second = np.where(even, np.stack([a, c, d], axis=-1), np.stack([b, c, d], axis=-1))
    points = np.stack(place(u, v), axis=-1).reshape(-1, 3)
    return Facets(points, np.concatenate([first.reshape(-1, 3), second.reshape(-1, 3)])), nodes


def movable(
    facets: Facets, section: Section, fixed: Sequence[tuple[Integers, Sequence[int]]]
) -> Moving:
    """A smooth shell: one rotation for every node."""
    panels = Corotational.of(facets, section, facets.dofs(), facets.triangles)
    held = np.concatenate([DOFS * nodes.ravel() + k for nodes, which in fixed for k in which])
    spins = DOFS * np.arange(len(facets.points))[:, None] + np.arange(3, 6)
    return Moving.of([panels], held, spins, float(np.sqrt(facets.areas().mean())))


def at_full_load(moving: Moving, loads: Array, first: float) -> Point:
    last = trace(moving, loads, first=first)[-1]
    assert last.factor == 1
    assert last.negative == 0
    return last


def test_tangents_are_those_of_the_forces() -> None:
    """Of a triangle and of a hinge, moved and turned at random: central differences."""
    random = np.random.default_rng(0)
    facets = Facets(random.normal(size=(3, 3)), np.array([[0, 1, 2]]))
    panel = Corotational.of(
        facets, Section.solid(1e3, 0.3, 0.3), facets.dofs(), np.array([[0, 1, 2]])
    )
    fold = Folds(
        np.array([2.0]), np.array([[0, 0.6, 0.8]]), np.array([[3, 4, 5, 9, 10, 11]]),
        np.array([[0, 1]]),
    )  # fmt: skip
    start = np.zeros((3, 6))
    start[:, :3] = 0.3 * random.normal(size=(3, 3))
    turns = exponentials(np.array([0.5, 1.0, -0.7])) @ exponentials(
        0.3 * random.normal(size=(3, 3))
    )

    def moved(step: Array) -> Moved:
        straight = np.tile([1, 1, 1, 0, 0, 0], 3)
        return Moved(
            start.ravel() + straight * step, exponentials(step.reshape(3, 6)[:, 3:]) @ turns
        )

    for part in (panel, fold):
        found = part.tangent(moved(np.zeros(18)))
        np.testing.assert_allclose(part.forces(moved(np.zeros(18))), found.forces, atol=1e-12)
        for k, dof in enumerate(part.dofs[0]):
            step = 1e-6 * np.eye(18)[dof]
            slope = (part.forces(moved(step)) - part.forces(moved(-step)))[0] / 2e-6
            scale = np.abs(found.matrices).max()
            np.testing.assert_allclose(found.matrices[0, :, k], slope, atol=1e-8 * scale)


def test_a_triangle_that_is_moved_as_a_whole_bears_nothing() -> None:
    """However its corners are numbered; and forces of a strained one turn with it."""
    random = np.random.default_rng(1)
    points = random.normal(size=(3, 3))
    strained, bent = (
        0.2 * random.normal(size=(3, 3)),
        exponentials(0.2 * random.normal(size=(3, 3))),
    )
    whole = exponentials(np.array([1.0, -2.0, 0.5]))
    found = []
    for order in ([0, 1, 2], [1, 2, 0]):
        facets = Facets(points, np.array([order]))
        panel = Corotational.of(
            facets, Section.solid(1e3, 0.3, 0.3), facets.dofs(), np.array([order])
        )
        still, moved = np.zeros((3, 6)), np.zeros((3, 6))
        still[:, :3] = points @ whole.T - points
        turned = np.tile(whole, (3, 1, 1))
        assert np.abs(panel.forces(Moved(still.ravel(), turned))).max() < 1e-12 * 1e3
        moved[:, :3] = (points + strained) @ whole.T - points
        total = np.zeros(18)
        total[panel.dofs[0]] = panel.forces(Moved(moved.ravel(), whole @ bent))[0]
        found.append(total.reshape(6, 3) @ whole)
        moved[:, :3] = strained
        unturned = panel.forces(Moved(moved.ravel(), bent))[0]
        np.testing.assert_allclose(found[-1].ravel()[panel.dofs[0]], unturned, atol=1e-10)
    np.testing.assert_allclose(found[0], found[1], atol=1e-10)


def test_rotation_vectors() -> None:
    """Logarithms undo exponentials, up to nearly half a turn."""
    way = np.array([0.6, 0.0, 0.8])
    for angle in (0.0, 1e-9, 1e-3, 1.0, 3.1):
        np.testing.assert_allclose(logarithms(exponentials(angle * way)), angle * way, atol=1e-12)


def test_a_cantilever_under_end_shear() -> None:
    """L 10, b 1, h 0.1, E 1.2e6, nu 0, P 4: -3.286 and 6.698 (Sze, Liu and Lo, table 1)."""
    facets, nodes = lattice(16, 1, lambda u, v: [10 * u, v, 0 * u])
    moving = movable(facets, Section.solid(1.2e6, 0.1, 0), [(nodes[0], range(6))])
    loads = np.zeros(moving.count)
    loads[DOFS * nodes[-1] + 2] = 2.0
    tip = at_full_load(moving, loads, 0.1).moved.displacements[DOFS * nodes[-1, 0] + np.arange(3)]
    np.testing.assert_allclose(tip[[0, 2]], [-3.286, 6.698], rtol=2e-3)


@pytest.mark.parametrize("share", [0.25, 0.5, 1.0])
def test_a_cantilever_under_an_end_moment(share: float) -> None:
    """L 12, EI 100: the moment 50 pi/3 bends it to a full circle, exactly."""
    facets, nodes = lattice(16, 1, lambda u, v: [12 * u, v, 0 * u])
    moving = movable(facets, Section.solid(1.2e6, 0.1, 0), [(nodes[0], range(6))])
    loads = np.zeros(moving.count)
    loads[DOFS * nodes[-1] + 4] = -share * 50 * np.pi / 3 / 2
    tip = at_full_load(moving, loads, 0.1).moved.displacements[DOFS * nodes[-1, 0] + np.arange(3)]
    angle = 2 * np.pi * share
    radius = 12 / angle
    exact = [radius * np.sin(angle) - 12, radius * (1 - np.cos(angle))]
    np.testing.assert_allclose(tip[[0, 2]], exact, atol=1.1e-3 * 12)


@pytest.mark.parametrize(
    ("cells", "margin"), [((6, 40), 0.03), pytest.param((10, 80), 0.01, marks=thorough)]
)
def test_a_slit_ring(cells: tuple[int, int], margin: float) -> None:
    """Radii 6 and 10, h 0.03, E 21e6, nu 0, 0.8 per length: 13.891 and 17.528 (their table 3).

    Triangles come from below: 13.56 and 17.18 with 6 x 40 cells, 13.81 and 17.45 with 10 x 80.
    """
    facets, nodes = lattice(
        *cells,
        lambda u, v: [
            (6 + 4 * u) * np.cos(2 * np.pi * v), (6 + 4 * u) * np.sin(2 * np.pi * v), 0 * u,
        ],
    )  # fmt: skip
    moving = movable(facets, Section.solid(21e6, 0.03, 0), [(nodes[:, 0], range(6))])
    loads = np.zeros(moving.count)
    share = np.full(cells[0] + 1, 4 / cells[0])
    share[[0, -1]] /= 2
    loads[DOFS * nodes[:, -1] + 2] = 0.8 * share
    found = at_full_load(moving, loads, 0.01).moved.displacements[DOFS * nodes[[0, -1], -1] + 2]
    np.testing.assert_allclose(found, [13.891, 17.528], rtol=margin)


@pytest.mark.parametrize(("cells", "margin"), [(16, 0.09), pytest.param(32, 0.015, marks=thorough)])
def test_a_pinched_hemisphere(cells: int, margin: float) -> None:
    """Hole of 18 degrees, R 10, h 0.04, E 6.825e7, nu 0.3, P 400: 4.067 and 8.178 (their table 6).

    A quarter of it; 3.88 and 7.51 with 16 x 16 cells, 4.00 and 7.93 with 24, 4.04 and 8.06 with 32.
    """
    high = np.deg2rad(72)
    facets, nodes = lattice(
        cells, cells,
        lambda u, v: [
            10 * np.cos(high * u) * np.cos(np.pi / 2 * v),
            10 * np.cos(high * u) * np.sin(np.pi / 2 * v),
            10 * np.sin(high * u),
        ],
    )  # fmt: skip
    held = [(nodes[:, 0], (1, 3, 5)), (nodes[:, -1], (0, 4, 5)), (nodes[0, :1], (2,))]
    moving = movable(facets, Section.solid(6.825e7, 0.04, 0.3), held)
    inwards, outwards = DOFS * nodes[0, 0], DOFS * nodes[0, -1] + 1
    loads = np.zeros(moving.count)
    loads[[inwards, outwards]] = -200.0, 200.0
    found = at_full_load(moving, loads, 0.02).moved.displacements[[outwards, inwards]]
    np.testing.assert_allclose(found, [4.067, -8.178], rtol=margin)


def test_the_full_load_is_reached_from_nearer_by(monkeypatch: pytest.MonkeyPatch) -> None:
    """A strip, 10 x 1 m, bent: at the full load Newton's steps end nowhere, but the third time."""
    facets, nodes = lattice(8, 1, lambda u, v: [10 * u, v, np.zeros_like(u)])
    moving = movable(facets, Section.solid(1.2e6, 0.1, 0.0), [(nodes[0], range(DOFS))])
    loads = np.zeros(moving.count)
    loads[DOFS * nodes[-1] + 2] = 2.0
    straight_there = at_full_load(moving, loads, 0.4).moved.displacements
    tried = iter([False, False])
    monkeypatch.setattr(path, "settle", lambda *at: settle(*at) if next(tried, True) else None)
    found = at_full_load(moving, loads, 0.4).moved.displacements
    np.testing.assert_allclose(found, straight_there, atol=1e-6)


def roof(thickness: float, cells: int) -> tuple[Array, Array, Array]:
    """Factors, deflections of the middle and numbers of unstable motions along its path."""
    facets, nodes = lattice(
        cells, cells, lambda u, v: [254 * v, -2540 * np.sin(0.1 * u), 2540 * np.cos(0.1 * u)]
    )
    held = [(nodes[-1], (0, 1, 2)), (nodes[0], (1, 3, 5)), (nodes[:, 0], (0, 4, 5))]
    moving = movable(facets, Section.solid(3102.75, thickness, 0.3), held)
    loads = np.zeros(moving.count)
    loads[DOFS * nodes[0, 0] + 2] = -750.0
    points = trace(moving, loads, first=0.02, longest=0.1)
    sinks = [-float(each.moved.displacements[DOFS * nodes[0, 0] + 2]) for each in points]
    factors, unstable = (
        [getattr(each, name) for each in points] for name in ("factor", "negative")
    )
    return np.array(factors), np.array(sinks), np.array(unstable)


CELLS = led_by([8, 16])
"""Along a side of the roof: 8 tell its extremes within 0.3 % of what 16 tell."""


@pytest.mark.parametrize("cells", CELLS)
def test_a_hinged_roof_snaps_through(cells: int) -> None:
    """12.7 mm, P 3000: up to 0.742 of it, down to 0.173, and up again (their table 8)."""
    factors, sinks, unstable = roof(12.7, cells)
    top = int(np.argmax(np.where(sinks < 15, factors, 0)))
    low = top + int(np.argmin(factors[top:]))
    assert factors[top] == pytest.approx(0.742, rel=0.005)
    assert factors[low] == pytest.approx(0.173, rel=0.02)
    rises, falls, again = np.s_[: top + 1], np.s_[low : top - 1 : -1], np.s_[low:]
    for branch, table in (
        (rises, [[0.3473, 3.087], [0.5647, 5.802], [0.6381, 7.057]]),
        (falls, [[0.2717, 17.094], [0.4442, 15.676], [0.6182, 14.188]]),
        (again, [[0.2303, 21.780], [0.3871, 24.049], [0.6644, 26.601], [0.9643, 28.663]]),
    ):
        wanted, expected = np.array(table).T
        np.testing.assert_allclose(
            np.interp(wanted, factors[branch], sinks[branch]), expected, rtol=0.02
        )
    assert set(unstable[: top - 1]) == set(unstable[low + 1 :]) == {0}
    assert set(unstable[top + 1 : low - 1]) == {1}


@pytest.mark.parametrize("cells", CELLS)
def test_a_thin_hinged_roof_snaps_back(cells: int) -> None:
    """6.35 mm: to 0.1953, back to -0.1288, while the middle rises from 17.0 to 14.45 (table 8)."""
    factors, sinks, _ = roof(6.35, cells)
    top = int(np.argmax(factors[sinks < 14]))
    assert factors[top] == pytest.approx(0.1953, rel=0.02)
    assert factors.min() == pytest.approx(-0.1288, rel=0.02)
    back = sinks[top : int(np.argmin(factors)) + 1]
    assert back.max() == pytest.approx(17.008, rel=0.02)
    assert back[back.argmax() :].min() == pytest.approx(14.451, rel=0.02)
    assert np.interp(1.0, factors[-5:], sinks[-5:]) == pytest.approx(38.22, rel=0.01)
