"""Residuals and sizes, measured on positions: what decides whether a result is right."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from orishell.motion import FoldedState, measure_fold_angles
from orishell.panels import area_vectors, corner_distances, diagonal_gaps, sector_angles
from orishell.pattern import CreaseValues, crease_signs

Array = NDArray[np.float64]

BLOCK = 2**14
"""Vertices looked at together: few enough for a processor's cache."""


@dataclass(frozen=True, slots=True)
class Residuals:
    """Worst departures from a rigid folding of a flat sheet, over the states measured.

    Parameters
    ----------
    panel_length
        Change of the six distances of a panel's corners against the flat sheet, relative to the
        sheet's diagonal.
    planarity
        Distance between a panel's two diagonals, relative to the sheet's diagonal.
    sector_sum_rad
        Difference of the four sector angles at an inner vertex from 2 pi (radians).
    fold_angle_rad
        Difference of the fold angles measured from the positions from the closed form (radians).
    """

    panel_length: float
    planarity: float
    sector_sum_rad: float
    fold_angle_rad: float


@dataclass(frozen=True, slots=True)
class AssignmentCheck:
    """Mountains and valleys over the states measured.

    Parameters
    ----------
    constant
        Whether no crease is a mountain in one state and a valley in another.
    three_to_one
        Whether each inner vertex has three creases of one sign and one of the other; a vertex
        with unfolded creases has two of one sign.
    """

    constant: bool
    three_to_one: bool


def measure_residuals(
    states: Iterable[FoldedState], flat: FoldedState
) -> tuple[Residuals, AssignmentCheck]:
    """Measure every state against the flat sheet, one state in memory at a time.

    Parameters
    ----------
    states
        The states, one after the other.
    flat
        The flat sheet.
    """
    blocks = _blocks(*flat.positions.shape[:2])
    distances = [corner_distances(_corners(flat.positions[block])) for block in blocks]
    worst = np.zeros(4)
    signs: CreaseValues | None = None
    constant = True
    for state in states:
        for block, expected in zip(blocks, distances, strict=True):
            worst = np.maximum(worst, _departures(state, block, expected))
        now = crease_signs(state.fold_angles)
        if signs is not None:
            constant = constant and not _opposite(now, signs)
            now = CreaseValues(
                np.where(now.row == 0, signs.row, now.row),
                np.where(now.column == 0, signs.column, now.column),
            )
        signs = now
    worst[:2] /= diagonal(flat.positions)
    check = AssignmentCheck(constant, signs is None or _three_to_one(signs))
    return Residuals(*worst.tolist()), check


def diagonal(flat: Array) -> float:
    """Diagonal of the flat sheet's bounding box, the length that residuals are relative to.

    Parameters
    ----------
    flat
        Vertices (rows, columns, 3) of the flat sheet.
    """
    return float(np.hypot(*extents(flat)[:2]))


def extents(positions: Array) -> tuple[float, float, float]:
    """Size of the bounding box along x, y and z.

    Parameters
    ----------
    positions
        Vertices (rows, columns, 3) in one state.
    """
    size = np.ptp(positions.reshape(-1, 3), axis=0)
    return float(size[0]), float(size[1]), float(size[2])


def sheet_area(positions: Array) -> float:
    """Area of all panels.

    Parameters
    ----------
    positions
        Vertices (rows, columns, 3) in any state.
    """
    return float(np.linalg.norm(area_vectors(_corners(positions)), axis=-1).sum())


def corrugation_depth(positions: Array) -> float:
    """Mean distance of inner vertices from the line between those above and below (length).

    Parameters
    ----------
    positions
        Vertices (rows, columns, 3) in one state.
    """
    inner = positions[:, 1:-1] if positions.shape[1] > 2 else positions
    base = inner[2:] - inner[:-2]
    arm = inner[1:-1] - inner[:-2]
    across = np.linalg.norm(np.cross(arm, base), axis=-1)
    return float((across / np.linalg.norm(base, axis=-1)).mean())


def _blocks(rows: int, columns: int) -> list[slice]:
    """Rows of vertices to look at together: all panels, and all vertices with what is around."""
    step = max(BLOCK // columns, 1)
    return [slice(start, min(start + step + 2, rows)) for start in range(0, max(rows - 2, 1), step)]


def _departures(state: FoldedState, block: slice, distances: Array) -> Array:
    """What :class:`Residuals` holds, of some rows in one state; lengths as they are."""
    positions = state.positions[block]
    corners = _corners(positions)
    measured, expected = measure_fold_angles(positions), state.fold_angles
    return np.array(
        [
            np.abs(corner_distances(corners) - distances).max(),
            diagonal_gaps(corners).max(),
            np.abs(_sector_sums(positions) - 2 * np.pi).max(initial=0.0),
            max(
                _largest_turn(measured.row, expected.row[block.start : block.stop - 2]),
                _largest_turn(measured.column, expected.column[block.start : block.stop - 1]),
            ),
        ]
    )


def _corners(positions: Array) -> Array:
    """Corners (rows-1, columns-1, 4, 3) of every panel: top left, then counter-clockwise."""
    return np.stack(
        [positions[:-1, :-1], positions[1:, :-1], positions[1:, 1:], positions[:-1, 1:]], axis=-2
    )


def _sector_sums(positions: Array) -> Array:
    """Sum of the four sector angles at every inner vertex (radians)."""
    angle = np.moveaxis(sector_angles(_corners(positions)), -1, 0)
    return np.asarray(angle[0, 1:, 1:] + angle[1, :-1, 1:] + angle[2, :-1, :-1] + angle[3, 1:, :-1])


def _largest_turn(first: Array, second: Array) -> float:
    """Largest difference of two arrays of angles, seen on the circle."""
    turn = np.mod(first - second + np.pi, 2 * np.pi) - np.pi
    return float(np.abs(turn).max(initial=0.0))


def _opposite(first: CreaseValues, second: CreaseValues) -> bool:
    """Whether some crease has opposite signs."""
    return bool((first.row * second.row < 0).any() or (first.column * second.column < 0).any())


def _three_to_one(signs: CreaseValues) -> bool:
    """Maekawa's theorem at every inner vertex, unfolded column creases left out."""
    around = np.stack(
        [
            signs.row[:, :-1],
            signs.row[:, 1:],
            signs.column[:-1],
            signs.column[1:],
        ]
    )
    return bool((np.abs(around.sum(axis=0)) == 2).all())
