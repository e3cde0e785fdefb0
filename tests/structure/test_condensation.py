"""Dense fronts in batches solve what one sparse factorisation of the whole solves."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from scipy.sparse.linalg import splu

from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array
from orishell.structure.mesh.hinges import hinge_elements, rigid_stiffness
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import SheetMesh, mesh_sheet
from orishell.structure.solve.conditions import between, joined, on_ground
from orishell.structure.solve.dissection import BLOCK, cut
from orishell.structure.solve.factorise import factorise
from orishell.structure.solve.factorised import Factorised
from samples import led_by

SECTION = Section.solid(1e9, 0.01, 0.3)


def folded(rows: int, columns: int) -> Array:
    """A corrugated vault."""
    u, v = np.meshgrid(np.linspace(0, np.pi, rows), np.arange(columns), indexing="ij")
    radius = 2 + 0.15 * (-1.0) ** np.arange(rows)[:, None]
    x, z = radius * np.cos(u), radius * np.sin(u)
    return np.stack([x, v + 0.1 * (-1.0) ** np.arange(rows)[:, None], z], axis=-1)


def structure(rows: int, columns: int, cells: int, crease: float, *, clamped: bool) -> Factorised:
    """Pinned or clamped along one foot, on the ground along the other, tied across."""
    grid = Grid(rows, columns)
    mesh: SheetMesh = mesh_sheet(folded(rows, columns), grid, cells, grading=0)
    elements = [mesh.elements(SECTION)]
    if crease:
        springs = min(crease, rigid_stiffness(mesh, SECTION))
        elements.append(hinge_elements(mesh, grid, springs))
    vertices = grid.vertices()
    held = mesh.translations()[vertices[0]].ravel()
    if clamped:
        turning = mesh.rotations()[np.isin(mesh.nodes, vertices[0])].ravel()
        held = np.concatenate([held, turning])
    pairs = np.stack([vertices[0], vertices[-1]], axis=1)
    stretch = np.full(columns, 1e5)
    feet = on_ground(vertices[-1], np.full(columns, 0.4))
    ties = between(mesh.facets.points, pairs, stretch, approach=False)
    return factorise(elements, mesh, held, joined([ties, feet]), grid)


@pytest.mark.parametrize(
    ("sheet", "cells"),
    led_by(
        sorted(
            itertools.product([(2, 2), (4, 5)], [1, 2, 3, 6]), key=lambda each: each == ((4, 5), 6)
        ),
        7,
    ),
)
@pytest.mark.parametrize(
    ("crease", "clamped"), [(0.0, False), (0.0, True), (30.0, False), (np.inf, True)]
)
def test_solves_as_one_sparse_factorisation(
    sheet: tuple[int, int], crease: float, cells: int, *, clamped: bool
) -> None:
    """By SuperLU, refined with residuals of more digits.

    Found 7e-12 apart, where panels are held, as SuperLU itself is after one refinement; 2e-10 where
    only springs of 1e-4 hold a mechanism.
    """
    held = structure(*sheet, cells, crease, clamped=clamped)
    loads = np.random.default_rng(cells).standard_normal((len(held.free), 3))
    wanted = solved_by_superlu(held, loads)
    found = held.spring_solve(loads)
    bound = 1e-10 if crease == np.inf else 1e-9
    assert np.abs(found - wanted).max() < bound * np.abs(wanted).max()
    np.testing.assert_array_equal(held.spring_solve(loads[:, 0]).shape, held.free.shape)


def solved_by_superlu(held: Factorised, loads: Array) -> Array:
    whole, matrix = splu(held._inner.tocsc()), held._inner.tocoo()
    rows, columns = matrix.coords
    values = matrix.data.astype(np.longdouble)[:, None]
    found = np.zeros(loads.shape, np.longdouble)
    for _ in range(5):
        rest = loads.astype(np.longdouble)
        np.subtract.at(rest, rows, values * found[columns])
        found += whole.solve(rest.astype(np.float64))
    return found.astype(np.float64)


@pytest.mark.parametrize(("rows", "columns", "cells"), [(1, 1, 1), (3, 5, 2), (2, 3, 9), (7, 1, 4)])
def test_blocks_are_of_one_panel_and_few_cells(rows: int, columns: int, cells: int) -> None:
    blocks = cut(rows, columns, cells)
    assert blocks.shape == (rows, columns, cells, cells)
    panels = np.broadcast_to(np.arange(rows * columns).reshape(rows, columns, 1, 1), blocks.shape)
    for block in np.unique(blocks):
        inside = blocks == block
        assert len(np.unique(panels[inside])) == 1
        _, _, down, right = np.nonzero(inside)
        height, width = np.ptp(down) + 1, np.ptp(right) + 1
        assert max(height, width) <= BLOCK
        assert inside.sum() == height * width
        above = block >> np.arange(1, int(block).bit_length())
        assert not np.isin(above, blocks).any()  # parts that are cut have no cells of their own
