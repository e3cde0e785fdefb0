"""Pieces of a sheet of whole boards: runs of rows, folded by themselves and joined at the target.

No hinge is at a joint, and nothing there folds flat. But the pieces fit each other where a hinge at
the height h that the conditions ask for would let all of them move as one: that height need not be
beyond the faces. Boards then stand back from the joint until they reach its bisecting plane at the
target, as those of a sandwich do from a crease:

    s = d tan(phi/2)

with the fold angle phi there and d from h to the face on which they close. So joints close exactly,
by boards that are as much shorter.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.motion import Mechanism
from orishell.motion.boards import Boards
from orishell.motion.grid import CreaseValues
from orishell.motion.hinges import Hinges, Joints
from orishell.motion.mechanism import panel_normals
from orishell.motion.quads import lengths, units
from orishell.numerics.arrays import Array

Rows = tuple[int, ...]
"""Numbers of rows of creases."""

LEAST_ROWS = 2
"""Rows of panels of a piece: the boards of a single row are a chain that has no one motion."""


def joint_rows(rows: int, pieces: int | Literal["whole", "auto"]) -> Rows:
    """Rows of creases at which so many rows of panels are parted.

    As few pieces as there can be of so many rows at most, as much alike as they can be, those of
    more rows first.

    Raises
    ------
    DesignError
        If they cannot be parted so.
    """
    if isinstance(pieces, str):
        return ()
    count = -(-rows // pieces)
    if pieces > rows or rows < LEAST_ROWS * count:
        raise _cannot_part(rows, pieces)
    each, more = divmod(rows, count)
    sizes = [each + 1] * more + [each] * (count - more)
    return tuple((np.cumsum(sizes[:-1]) - 1).tolist())


def numbers_of_rows(rows: int) -> list[int]:
    """Numbers of rows of panels that the largest piece can have, if there are two or more."""
    counts = range(2, rows // LEAST_ROWS + 1)
    return sorted({-(-rows // count) for count in counts})


def _cannot_part(rows: int, pieces: int) -> DesignError:
    whole, others = pieces > rows, numbers_of_rows(rows)
    return DesignError(
        "the sheet has fewer rows of panels than a piece"
        if whole
        else "the rows of panels do not part into pieces of two: one row would be left",
        keys=("panel.pieces",),
        size=f"it has {rows}",
        candidates=[
            *(Remedy({"panel.pieces": most}) for most in (reversed(others) if whole else others)),
            Remedy({"panel.pieces": None}),
        ],
    )


def find_joints(mechanism: Mechanism, hinges: Hinges, rows: Rows) -> Joints:
    """The joints along rows of creases, and how far boards are cut back there."""
    numbers = list(rows)
    fold = np.abs(mechanism.fold_angles(mechanism.target_drive).row[numbers])
    sign, height = hinges.signs.row[numbers], hinges.heights.row[numbers]
    below = [row + 1 for row in numbers]
    level = np.stack([hinges.levels[numbers], hinges.levels[below]])
    deep = np.where(sign > 0, level + hinges.thickness - height, height - level)
    cuts = np.maximum(np.where(sign == 0, 0.0, deep), 0.0) * np.tan(0.5 * fold)
    return Joints(rows, cuts, np.cos(fold).mean(axis=1))


def joint_axes(hinges: Hinges, positions: Array) -> Array:
    """Lines along which pieces are joined, from end to end (J, columns-1, 2, 3), at the target.

    Half way between the edges of the two boards on the faces on which they close.

    positions: Vertices (rows, columns, 3) there.
    """
    assert hinges.joints is not None
    normals = panel_normals(positions)
    shifts = hinges.shifts(normals.reshape(-1, 3)).reshape(normals.shape)
    rows = np.array(hinges.joints.rows)
    crease = positions[rows + 1]
    along, sign = units(np.diff(crease, axis=1)), hinges.signs.row[rows]
    found = np.zeros((*along.shape[:2], 2, 3))
    for board, cut, side in zip((rows, rows + 1), hinges.joints.cuts, (1.0, -1.0), strict=True):
        n, share = normals[board], 0.5 * (1 + sign)
        face = (hinges.levels[board] + share * hinges.thickness)[..., None] * n
        inward = side * cut[..., None] * np.cross(n, along)
        found += 0.5 * (shifts[board] + face + inward)[:, :, None]
    return np.asarray(found + np.stack([crease[:, :-1], crease[:, 1:]], axis=2))


def joint_openings(mechanism: Mechanism, boards: Boards) -> Array:
    """How far boards on either side of joints are apart at the target (J, columns-1) (length).

    Between the edges on the faces on which they close, square to the crease.
    """
    hinges = boards.hinges
    assert isinstance(hinges, Hinges)
    assert hinges.joints is not None
    faces = mechanism.grid.faces_vertices()
    flat, points = (
        mechanism.positions(drive).reshape(-1, 3) for drive in (0.0, mechanism.target_drive)
    )
    plates = boards.chosen(~boards.arms)
    corners = plates.carried(faces, flat[:, :2], points)
    corners = corners.reshape(*hinges.levels.shape, *corners.shape[1:])
    rows = list(hinges.joints.rows)
    top = np.where(hinges.signs.row[rows] < 0, 0, -1)
    # A side begins at the corner of its number, or of twice that and one where corners are cut.
    step = corners.shape[3] // 4

    def edges(board_rows: list[int], side: int) -> Array:
        first = side if step == 1 else 2 * side + 1
        ends = [first, (first + 1) % corners.shape[3]]
        own = corners[board_rows][..., ends, :]
        return np.take_along_axis(own, top[..., None, None, None], axis=2)[:, :, 0]

    above, below = edges(rows, 1), edges([row + 1 for row in rows], 3)
    along = above[..., 1, :] - above[..., 0, :]
    return lengths(np.cross(below.mean(axis=2) - above.mean(axis=2), units(along)))


def hinges_of(
    signs: CreaseValues, heights: CreaseValues, levels: Array, joints: Rows = ()
) -> Hinges:
    """Hinges at heights, with boards of thickness 1 at levels (rows-1, columns-1).

    There are none, and no arms, in the rows of creases that are ``joints``.
    """

    def arms(sign: Array, height: Array, level: Array) -> Array:
        off = np.where(sign > 0, height - level - 1.0, level - height)
        return np.where(sign == 0, 0.0, off)

    across, down = (levels[:, :-1], levels[:, 1:]), (levels[:-1], levels[1:])
    of_rows = np.stack([arms(signs.row, heights.row, each) for each in down])
    of_rows[:, list(joints)] = 0.0
    of_columns = np.stack([arms(signs.column, heights.column, each) for each in across])
    return Hinges(signs, heights, levels, 1.0, (of_rows, of_columns))
