"""Where a sheet is: a pose at its target that the flat sheet turns to, and the level one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.families.flat_foldable.mechanism import FlatFoldable
from orishell.families.flat_foldable.net import CORNERS, Net, Sheet
from orishell.families.shared.axes import axes_of
from orishell.numerics.arrays import Array

LONGEST = 2.0
"""Creases that end at feet are made longer by this factor at most, so that these are level."""


def posed(sheet: Sheet, rotation: Array, place: Array) -> FlatFoldable:
    """The sheet whose target is that of ``FlatFoldable(sheet)``, turned and then moved.

    As much as can be of the rotation (3, 3) is the heading of the flat sheet: what is left has a
    level axis, so that the sheet turns as little as possible while it folds.

    place: Of the middle vertex (3,).
    """
    w, x, y, z = _quaternion(rotation)
    heading = 2 * float(np.arctan2(z, w))
    # Divided by the turn about z, (x, y) of the quaternion turn by half of it.
    c, s = np.cos(0.5 * heading), np.sin(0.5 * heading)
    axis = np.array([c * x - s * y, s * x + c * y, 0.0])
    size = float(np.hypot(x, y))
    angle = 2 * float(np.arctan2(size, np.hypot(w, z)))
    turn = axis * (angle / size) if size > 0 else np.zeros(3)
    return FlatFoldable(sheet, heading, turn, np.asarray(place, dtype=np.float64))


def levelled(net: Net, *, arched: bool = False) -> FlatFoldable:
    """The sheet level about the origin: its rows run along x at the target, its columns along -y.

    arched: Whether its middle has to lie above its first and last row: else it is folded to the
        other side.
    """
    sheet = net.march()
    free = FlatFoldable(sheet)
    shell = free.positions(free.target_drive)
    axes = axes_of(shell)
    heights = (shell @ axes[2])[:, 1:-1].mean(axis=1)
    if arched and heights[[0, -1]].sum() > heights.min() + heights.max():
        return levelled(replace(net, x=-net.x, y=-net.y))
    centre = shell[1:-1, 1:-1].reshape(-1, 3).mean(axis=0)
    return posed(sheet, axes, -axes @ centre)


def with_level_ends(shell: FlatFoldable) -> FlatFoldable:
    """The shell with creases to its first and last row so long that these lie at one height.

    At the lowest height that they have; itself if some of them do not go down to there.
    """
    places, net = shell.positions(shell.target_drive)[..., 2], shell.sheet.net
    ground = places[[0, -1]].min()
    reached = []
    for end, beside, lengths in ((0, 1, net.top), (-1, -2, net.bottom)):
        drop = places[beside] - places[end]
        needed = places[beside] - ground
        if not (drop[1:-1] > 0).all() or (needed[1:-1] > LONGEST * drop[1:-1]).any():
            return shell
        reached.append((lengths * (needed / drop)[1:-1, None], end, beside))
    corners = net.corners.copy()
    for number, (row, column) in enumerate(CORNERS):
        near_row, near_column = (1 if at == 0 else -2 for at in (row, column))
        near = places[near_row, near_column]
        side = corners[number, 0, 0] * (places[near_row, column] - near)
        # The border vertex beside the corner is on the ground now.
        corners[number, 1, 0] = (ground - near - side) / (ground - near)
    sheet = replace(net, top=reached[0][0], bottom=reached[1][0], corners=corners).march()
    return replace(shell, sheet=sheet)


def _quaternion(rotation: Array) -> Array:
    """Unit quaternion (4,), w first, of a rotation (3, 3): by the largest of its components."""
    r = rotation
    squares = np.array(
        [1 + r.trace(), *(1 + 2 * r[k, k] - r.trace() for k in range(3))]
    )  # four times those of the components
    # Products of all components by each other.
    products = np.array(
        [
            [squares[0], r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]],
            [r[2, 1] - r[1, 2], squares[1], r[1, 0] + r[0, 1], r[0, 2] + r[2, 0]],
            [r[0, 2] - r[2, 0], r[1, 0] + r[0, 1], squares[2], r[2, 1] + r[1, 2]],
            [r[1, 0] - r[0, 1], r[0, 2] + r[2, 0], r[2, 1] + r[1, 2], squares[3]],
        ]
    )
    found = products[int(squares.argmax())]
    found = found / np.linalg.norm(found)
    return np.asarray(-found if found[0] < 0 else found)
