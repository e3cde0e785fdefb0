"""Factorising a structure: with springs that hold what nothing else does."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.elements import Elements
from orishell.structure.mesh.sheet import SheetMesh, points_by_dofs
from orishell.structure.solve.conditions import Conditions, make_rows
from orishell.structure.solve.factorised import Factorised
from orishell.structure.solve.fronts import condense

LOOSE, LOOSEST = 3e-14, 3
"""A matrix is singular if some shape is less stiff than this share of its largest entry; iterations
by which that is found."""
SWINGING = 400
"""At most so many vertices have springs."""
RESTRAINED = 1e-9
"""A motion of the whole that moves supported vertices by less than this share is free."""
TOGETHER = 64
"""Rows whose displacements are found at a time: more of them take memory, and no less time."""
SPRING = 1e-4
"""Springs at vertices, by the mean stiffness of nodes."""


def factorise(
    elements: Sequence[Elements],
    mesh: SheetMesh,
    supported: Integers,
    conditions: Conditions,
    grid: Grid,
) -> Factorised:
    """Factorise a structure.

    supported: Freedoms (H,) that are supported.
    grid: The grid of the sheet. Springs at its corners hold what nothing else does while the matrix
    is factorised; at all its vertices, where that is not enough because some creases do not fold
    and let their panels swing.
    Raises DesignError: If it swings in so many ways.
    """
    vertices = grid.vertices()
    sheet = mesh, grid
    found = _sprung(elements, sheet, supported, conditions, vertices[np.ix_([0, -1], [0, -1])])
    if found is None and vertices.size <= SWINGING:
        found = _sprung(elements, sheet, supported, conditions, vertices)
    if found is None:
        raise DesignError(
            "the shell is a mechanism of many ways to move: creases that do not fold at the target "
            "let its panels swing about the others",
            keys=("structure.crease_stiffness",),
        )
    return found


def _sprung(
    elements: Sequence[Elements],
    sheet: tuple[SheetMesh, Grid],
    supported: Integers,
    conditions: Conditions,
    vertices: Integers,
) -> Factorised | None:
    """The structure with springs at some vertices; None if it is singular all the same."""
    from scipy.sparse import csr_array

    mesh, grid = sheet
    first, *others = (each.assembled() for each in elements)
    stiffness = sum(others, first)
    free = np.setdiff1d(np.arange(mesh.count), supported)
    ground = conditions.nodes[conditions.rough]
    axes, corners = np.eye(3), vertices.ravel()
    parts = [
        (conditions.nodes, conditions.directions),
        (np.repeat(ground, 2, axis=0), np.tile(axes[:2], (len(ground), 1))),
        (np.repeat(corners, 3)[:, None].repeat(2, axis=1), np.tile(axes, (len(corners), 1))),
    ]
    nodes, directions = (np.concatenate(each) for each in zip(*parts, strict=True))
    every_row = make_rows(nodes, directions, mesh.count)
    rows = csr_array(every_row[:, free])
    springs = np.full(len(nodes), SPRING * stiffness.diagonal()[: mesh.translations().size].mean())
    own = np.flatnonzero(conditions.compliance)
    springs[own] = 1 / conditions.compliance[own]
    sprung = (stiffness[free][:, free] + rows.T @ (rows * springs[:, None])).tocsc()
    del stiffness, first, others
    factors = condense(mesh, grid, elements, (every_row, springs), free)
    if factors is None:
        return None
    if _loosest(factors.solve, len(free)) < LOOSE * sprung.diagonal().max():
        return None
    spread = np.empty((len(free), len(nodes)))
    for begin in range(0, len(nodes), TOGETHER):
        some = np.s_[begin : begin + TOGETHER]
        loads = rows[some].toarray().T
        moved = factors.solve(loads)
        spread[:, some] = moved + factors.solve(loads - sprung @ moved)
    flexibility = rows @ spread
    return Factorised(
        tuple(elements),
        free,
        conditions,
        mesh.node_count,
        points_by_dofs(mesh),
        every_row,
        rows,
        springs,
        spread,
        0.5 * (flexibility + flexibility.T),
        _rigid_motions(mesh, free, supported),
        sprung,
        factors,
    )


def _rigid_motions(mesh: SheetMesh, free: Integers, supported: Integers) -> Array:
    """Motions of the whole (n, r) that supported dofs (H,) leave; orthonormal."""
    nodes = mesh.facets.points[: mesh.node_count]
    away = nodes - nodes.mean(axis=0)
    size = float(np.linalg.norm(np.ptp(away, axis=0)))
    motions = np.zeros((mesh.count, 6))
    for axis, unit in enumerate(np.eye(3)):
        motions[mesh.translations()[:, axis], axis] = 1.0
        motions[mesh.translations(), 3 + axis] = np.cross(unit, away) / size
        motions[mesh.rotations()[..., axis], 3 + axis] = 1 / size
        motions[mesh.count - 3 * mesh.turns + axis :: 3, 3 + axis] = 1 / size
    _, sizes, ways = np.linalg.svd(motions[supported], full_matrices=True)
    restrained = int((sizes > RESTRAINED * sizes.max(initial=0.0)).sum())
    return np.linalg.qr(motions[free] @ ways[restrained:].T)[0]


def _loosest(solve: Callable[[Array], Array], size: int) -> float:
    """About the least stiffness of all shapes, by inverse iteration."""
    shape = np.cos(np.arange(size))
    for _ in range(LOOSEST):
        shape = solve(shape / np.linalg.norm(shape))
    return float(1 / np.linalg.norm(shape))
