"""Whole boards as a structure: their plates and hinges in a state, and what is not analysed."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.design import Design
from orishell.motion import Mechanism
from orishell.motion.boards import Boards
from orishell.motion.hinges import Hinges
from orishell.motion.mechanism import panel_normals
from orishell.numerics.arrays import Array
from orishell.solids.boards import inset_panels
from orishell.structure.mesh.boards import LEAST_CELLS, HingedPlates, mesh_boards
from orishell.structure.mesh.sheet import CORNERS, SheetMesh
from orishell.structure.settings import Structure

ON_FACE = 1e-6
"""A hinge nearer to the faces of its boards than this share of their thickness lies on them."""


def check_whole_boards(structure: Structure) -> None:
    """Refuse what is not analysed of whole boards.

    Raises InputError: If large displacements are asked for, or cells are too few for hinges.
    """
    if structure.nonlinear:
        raise InputError(
            "large displacements of whole boards on hinges are not followed",
            keys=("structure.nonlinear",),
            got="true",
            expected="false: arms that turn far are not in it",
            remedy="nonlinear = false",
        )
    if structure.cells < LEAST_CELLS:
        raise InputError(
            "cells are too few for the hinges of whole boards",
            keys=("structure.cells",),
            got=str(structure.cells),
            expected=f"{LEAST_CELLS} or more: a hinge has two nodes at least",
        )


def mesh_whole_boards(design: Design, sheet: Mechanism, positions: Array, cells: int) -> SheetMesh:
    """Mesh the boards of a design.

    positions: Vertices (rows, columns, 3) of its sheet in the state.
    """
    return mesh_boards(_plates(design, sheet, positions), sheet.grid, cells)


def corners_at_vertices(design: Design, sheet: Mechanism, mesh: SheetMesh, drive: float) -> Array:
    """The corners (V, 3) that are nodes at vertices of a mesh, at any drive (radians)."""
    corners = _plates(design, sheet, sheet.positions(drive)).corners
    number = mesh.nodes[:, *CORNERS]
    at = np.nonzero(number < sheet.grid.vertex_count)
    found = np.empty((sheet.grid.vertex_count, 3))
    found[number[at]] = corners[at]
    return found


def _plates(design: Design, sheet: Mechanism, positions: Array) -> HingedPlates:
    assert design.hinges is not None
    assert design.panel is not None
    return hinged_plates(design.hinges, design.panel.gap, sheet.positions(0.0), positions)


def hinged_plates(hinges: Hinges, gap: float, flat: Array, positions: Array) -> HingedPlates:
    """The plates of whole boards, half way up, and the axes of their hinges in a folded state.

    gap: Between two boards, half of it off each (length).
    flat, positions: Vertices (rows, columns, 3) in the flat sheet and in the state.
    """
    grid = hinges.grid
    faces, edges = grid.faces_vertices(), grid.faces_edges()
    inner = np.bincount(edges.ravel()) > 1
    lying, folded = flat.reshape(-1, 3), positions.reshape(-1, 3)
    back = np.where(inner[edges], 0.5 * gap, 0.0)
    outline = inset_panels(lying[faces, :2], back, grid)
    middle = (hinges.levels + 0.5 * hinges.thickness).ravel()
    at = np.concatenate([outline, np.broadcast_to(middle[:, None, None], (*faces.shape, 1))], -1)
    number = np.arange(len(faces))
    boards = Boards(number, 0 * number, at[:, None], hinges)
    corners = boards.carried(faces, lying[:, :2], folded)[:, 0]

    normals = panel_normals(positions).reshape(-1, 3)
    first = np.zeros(len(inner), np.int64)
    for side in (0, 3, 1, 2):  # a crease is the bottom or the right edge of its first panel
        first[edges[:, side]] = number
    height = hinges.heights.on_edges()
    off = hinges.shifts(normals)[first] + height[:, None] * normals[first]
    axes = folded[grid.edges_vertices()] + off[:, None]
    row, column = (each.max(axis=0) for each in hinges.arms)
    arms = type(hinges.heights)(row, column).on_edges()
    return HingedPlates(corners, axes, arms <= ON_FACE * hinges.thickness)
