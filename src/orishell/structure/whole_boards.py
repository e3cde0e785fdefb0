"""Whole boards as a structure: plates and hinges in a state, chamfers, and what is not analysed.

Where pieces are joined, hinges are along the edges in which their boards meet.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.errors import InputError
from orishell.design import Design
from orishell.design.fittings import SHORT
from orishell.motion import Mechanism
from orishell.motion.boards import Boards
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.hinges import Hinges
from orishell.motion.mechanism import panel_normals
from orishell.numerics.arrays import Array
from orishell.solids.boards import inset_panels
from orishell.solids.hinged.joints import joint_axes
from orishell.structure.mesh.boards import LEAST_CELLS, HingedPlates
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import CORNERS, SheetMesh
from orishell.structure.settings import Structure

POISSON = 0.3
"""Poisson's ratio of arms."""


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


def plates_of(design: Design, structure: Structure, sheet: Mechanism, drive: float) -> HingedPlates:
    """The plates and hinges of a design at a drive (radians)."""
    hinges, build = design.hinges, design.panel
    assert isinstance(hinges, Hinges)
    assert build is not None
    fins = None
    if structure.arm_modulus is not None:
        fins = Section.solid(structure.arm_modulus, build.fin, POISSON)
    flat, positions = sheet.positions(0.0), sheet.positions(drive)
    return hinged_plates(hinges, build.gap, flat, positions, fins)


def corners_at_vertices(plates: HingedPlates, mesh: SheetMesh, grid: Grid) -> Array:
    """The corners (V, 3) of plates that are nodes at vertices of a mesh."""
    number = mesh.nodes[:, *CORNERS]
    at = np.nonzero(number < grid.vertex_count)
    found = np.empty((grid.vertex_count, 3))
    found[number[at]] = plates.corners[at]
    return found


def arm_warnings(structure: Structure, mesh: SheetMesh) -> Iterator[str]:
    """What an engineer should read of arms."""
    hinges = mesh.offsets
    if hinges is not None and hinges.heights.any() and structure.arm_modulus is None:
        yield (
            "arms of hinges are taken as rigid, so they draw more of the moments than fins that "
            "bend: say how stiff their material is (arm_modulus in [structure])"
        )


def hinged_plates(
    hinges: Hinges, gap: float, flat: Array, positions: Array, fins: Section | None = None
) -> HingedPlates:
    """The plates of whole boards, half way up, and the axes of their hinges in a folded state.

    gap: Between two boards, half of it off each (length).
    flat, positions: Vertices (rows, columns, 3) in the flat sheet and in the state.
    fins: The section of arms that give; None if arms are rigid.
    """
    grid = hinges.grid
    faces, edges = grid.faces_vertices(), grid.faces_edges()
    inner = np.bincount(edges.ravel()) > 1
    lying, folded = flat.reshape(-1, 3), positions.reshape(-1, 3)
    back = np.where(inner[edges], 0.5 * gap, 0.0)
    outline = inset_panels(lying[faces, :2], back + hinges.cut_back, grid)
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
    if hinges.joints is not None:  # boards are joined where they meet
        across = grid.columns - 1
        rows = axes[: grid.rows * across].reshape(grid.rows, across, 2, 3)
        rows[np.array(hinges.joints.rows) + 1] = joint_axes(hinges, positions)
    arms = np.stack(
        [CreaseValues(*both).on_edges() for both in zip(*hinges.arms, strict=True)], axis=1
    )
    arms[arms - hinges.knuckle <= SHORT * hinges.thickness] = 0.0
    return HingedPlates(corners, axes, arms, fins)
