"""Residuals measured on positions, which decide whether a result is right, and signs of creases."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from orishell.conventions.errors import VerificationError
from orishell.motion import FoldedState, Mechanism, diagonal, measure_fold_angles
from orishell.motion.grid import UNFOLDED, Grid, crease_signs
from orishell.motion.layout import edge_folds, mesh_of, points_of
from orishell.motion.mesh import measure_mesh_folds, measure_sector_sums
from orishell.motion.quads import (
    corner_distances,
    diagonal_gaps,
    grid_corners,
    is_level,
    sector_angles,
)
from orishell.numerics.arrays import Array, Booleans, Integers


def turn_between(first: Array, second: Array) -> Array:
    """The smaller turn from one angle to another, from 0 to pi, for arrays of angles (radians)."""
    return np.asarray(np.abs(np.mod(first - second + np.pi, 2 * np.pi) - np.pi))


def meets_maekawa(edges: Integers, signs: Array, vertex_count: int) -> Booleans:
    """Which vertices (V,) meet Maekawa's condition: as many mountains as valleys but for two.

    So a vertex with four creases that fold has three of one kind and one of the other, and one
    with unfolded creases has two of one kind. Signs (E,) are +1 valley, -1 mountain, 0 neither.
    """
    total = np.bincount(edges.T.ravel(), np.tile(signs, 2), minlength=vertex_count)
    return np.asarray(np.abs(total) == 2)


class SignsSeen:
    """Which edges have been mountains and which valleys in the states so far."""

    def __init__(self, count: int) -> None:
        self.mountain = np.zeros(count, dtype=np.bool_)
        self.valley = self.mountain.copy()

    def see(self, signs: Array) -> Booleans:
        """Take in the signs (E,) of a state, and say which edges have had the opposite one."""
        changed = (signs > 0) & self.mountain | (signs < 0) & self.valley
        self.mountain |= signs < 0
        self.valley |= signs > 0
        return np.asarray(changed)


BLOCK = 2**14
"""Vertices looked at together: few enough for a processor's cache."""

LENGTH_LIMIT, ANGLE_LIMIT = 1e-9, 1e-6
"""Residuals above these (relative lengths, radians) mean that the program, not the design, is
wrong: a panel may be as small as a hundred-millionth of the coordinates, and the rounding of
coordinates turns it by so much."""


@dataclass(frozen=True, slots=True)
class Residuals:
    """Worst departures from a rigid folding of a flat sheet, over the states measured."""

    # change of the six distances of a panel's corners against the flat sheet, relative to the
    # sheet's diagonal
    panel_length: float
    planarity: float  # distance between a panel's two diagonals, relative to the sheet's diagonal
    # difference of the four sector angles at an inner vertex from 2 pi, or, where the sheet is not
    # flat at drive 0, from what they are there (radians)
    sector_sum_rad: float
    # difference of the fold angles measured from the positions from the closed form (radians)
    fold_angle_rad: float


@dataclass(frozen=True, slots=True)
class AssignmentCheck:
    """Whether mountains and valleys stay so over the states, and meet Maekawa's condition."""

    constant: bool  # whether no crease is a mountain in one state and a valley in another
    # whether each inner vertex meets Maekawa's condition: it has three creases of one sign and one
    # of the other; a vertex with unfolded creases has two of one sign. None where the sheet is not
    # flat at drive 0, for which there is no such condition.
    maekawa: bool | None


def measure_residuals(
    states: Iterable[FoldedState], flat: FoldedState
) -> tuple[Residuals, AssignmentCheck]:
    """Measure every state against that at drive 0, one state in memory at a time.

    Parameters
    ----------
    states
        The states, one after the other.
    """
    blocks = _blocks(*flat.positions.shape[:2])
    begun = [flat.positions[block] for block in blocks]
    distances = [corner_distances(grid_corners(each)) for each in begun]
    one_sheet = is_level(flat.positions)
    sums = [np.full((1, 1), 2 * np.pi) if one_sheet else _sector_sums(each) for each in begun]
    worst = np.zeros(4)
    grid = Grid(*flat.positions.shape[:2])
    edges = grid.edges_vertices()
    seen, constant = SignsSeen(len(edges)), True
    for state in states:
        for block, distance, angle in zip(blocks, distances, sums, strict=True):
            worst = np.maximum(worst, _departures(state, block, distance, angle))
        constant &= not seen.see(crease_signs(state.fold_angles).on_edges()).any()
    worst[:2] /= diagonal(flat.positions)
    signs = seen.valley.astype(np.float64) - seen.mountain
    met = meets_maekawa(edges, signs, grid.vertex_count)[grid.vertices()[1:-1, 1:-1]]
    maekawa = bool(met.all()) if one_sheet else None
    return Residuals(*worst.tolist()), AssignmentCheck(constant, maekawa)


def measure_with_flaps(
    mechanism: Mechanism, drives: Iterable[float]
) -> tuple[Residuals, AssignmentCheck]:
    """Measure a sheet with flaps beside its grid, all of its panels and edges.

    Vertices at which flaps end at a slit are no inner ones.
    """
    mesh, flat = mesh_of(mechanism), points_of(mechanism, 0.0)
    inner, size = mesh.inner_vertices(), float(np.linalg.norm(np.ptp(flat, axis=0)))
    distances = corner_distances(flat[mesh.faces])
    convex = np.zeros(mesh.faces.shape, np.bool_)
    worst = np.zeros(4)
    seen, constant = SignsSeen(len(mesh.edges)), True
    for drive in drives:
        points, folds = points_of(mechanism, drive), edge_folds(mechanism, drive)
        corners = points[mesh.faces]
        sums = measure_sector_sums(mesh, points, convex)[inner]
        found = np.array(
            [
                np.abs(corner_distances(corners) - distances).max(),
                diagonal_gaps(corners).max(),
                np.abs(sums - 2 * np.pi).max(initial=0.0),
                turn_between(measure_mesh_folds(mesh, points), folds).max(),
            ]
        )
        worst = np.maximum(worst, found)
        signs = np.where(np.abs(folds) > UNFOLDED, np.sign(folds), 0.0)
        constant &= not seen.see(signs).any()
    worst[:2] /= size
    met = meets_maekawa(mesh.edges, seen.valley.astype(np.float64) - seen.mountain, len(flat))
    return Residuals(*worst.tolist()), AssignmentCheck(constant, bool(met[inner].all()))


def _blocks(rows: int, columns: int) -> list[slice]:
    """Rows of vertices to look at together: all panels, and all vertices with what is around."""
    step = max(BLOCK // columns, 1)
    return [slice(start, min(start + step + 2, rows)) for start in range(0, max(rows - 2, 1), step)]


def _departures(state: FoldedState, block: slice, distances: Array, sums: Array) -> Array:
    """The four :class:`Residuals` of some rows in one state, lengths not yet relative."""
    positions = state.positions[block]
    corners = grid_corners(positions)
    measured, expected = measure_fold_angles(positions), state.fold_angles
    return np.array(
        [
            np.abs(corner_distances(corners) - distances).max(),
            diagonal_gaps(corners).max(),
            np.abs(_sector_sums(positions) - sums).max(initial=0.0),
            max(
                turn_between(found, asked).max(initial=0.0)
                for found, asked in (
                    (measured.row, expected.row[block.start : block.stop - 2]),
                    (measured.column, expected.column[block.start : block.stop - 1]),
                )
            ),
        ]
    )


def _sector_sums(positions: Array) -> Array:
    """Sum of the four sector angles at every inner vertex (radians)."""
    angle = np.moveaxis(sector_angles(grid_corners(positions)), -1, 0)
    return np.asarray(angle[0, 1:, 1:] + angle[1, :-1, 1:] + angle[2, :-1, :-1] + angle[3, 1:, :-1])


def require_verified(residuals: Residuals, assignment: AssignmentCheck) -> None:
    """Refuse states that are not those of rigid panels: a fault of the program."""
    lengths = max(residuals.panel_length, residuals.planarity)
    angles = max(residuals.sector_sum_rad, residuals.fold_angle_rad)
    if lengths <= LENGTH_LIMIT and angles <= ANGLE_LIMIT:
        if assignment.constant and assignment.maekawa is not False:
            return
        raise VerificationError(
            "mountains and valleys do not fit the motion: this is a fault of the program"
        )
    raise VerificationError(
        f"the states are not those of rigid panels: lengths change by {lengths:.3g} of the sheet's "
        f"diagonal (limit {LENGTH_LIMIT:g}), angles are wrong by {angles:.3g} rad (limit "
        f"{ANGLE_LIMIT:g}); this is a fault of the program"
    )
