"""Plane plates across folds of a shell that stands: how far they stand off panels, their boards.

A plate that is 2 g thick keeps off panels that are 2 h thick, and reach h to either side. In the
section square to their common line u let alpha be the angle between plate and panel. The edge of
the plate, cut square and d from u, has its corners d sin(alpha) -+ g cos(alpha) over the panel's
plane: above the board if

    d >= (h + g abs(cos(alpha)))/sin(alpha).

Boards end at their creases. So where alpha is more than a right angle the plate is clear of the
board, too, if it ends before the plane through u square to the panel,

    d >= -g tan(alpha).

The less of both will do, and the most of all panels beside a line is taken for each.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Protocol

import numpy as np

from orishell.design import Design, PanelSpec
from orishell.design.part import SHELL, DocumentState, Part
from orishell.motion.boards import Boards
from orishell.motion.layout import points_of
from orishell.motion.mesh import build_mesh
from orishell.numerics.arrays import Array, Integers

OFF_PLANE = 1e-6
"""An angle with a smaller sine leaves a plate no room (radians)."""


class Plates(Protocol):
    """Plates of one kind at the target, in the frame of the sheet."""

    @property
    def corners(self) -> Array:
        """Corners (G, 4, 3), the first of each at its vertex."""

    @property
    def names(self) -> tuple[str, ...]:
        """What each is called: its kind, and row and column of its vertex."""

    @property
    def build(self) -> PanelSpec | None:
        """What they are made of; None if they have no thickness."""

    def lying(self) -> Array:
        """Corners (G, 4, 2) of each in its own plane, its vertex in the origin."""

    def boards(self, flat: Array, levels: int) -> Boards:
        """Their boards, as panels of their own whose first corners lie at places (G, 2)."""


def lying(corners: Array) -> Array:
    """Corners (G, K, 2) of plane plates (G, K, 3), each in its own plane.

    The first corner is the origin, the second is on the x axis, and y goes up to the last.
    """
    away = corners - corners[:, :1]
    along = _unit(away[:, 1])
    upright = away[:, -1] - (away[:, -1] * along).sum(axis=1, keepdims=True) * along
    axes = np.stack([along, _unit(upright)], axis=1)
    return np.asarray(np.einsum("gcx,gkx->gck", away, axes))


def upright_boards(cut: Array, build: PanelSpec, levels: int) -> Boards:
    """Boards of plates (G, K, 2) that are cut square: one to each, or those on a membrane.

    levels: At how many heights boards have outlines.
    """
    (above, below), inner = build.heights, 0.5 * build.membrane
    layers = {0: (-below, above)}
    if not build.is_solid:
        faces = {1: (inner, above), -1: (-below, -inner)}
        layers = {face: each for face, each in faces.items() if build.has_boards(face)}
    low, high = np.transpose(list(layers.values()))
    heights = np.linspace(low, high, levels, axis=1)
    count, corners = cut.shape[:2]
    shape = count, len(layers), levels, corners
    outlines = np.concatenate(
        [
            np.broadcast_to(cut[:, None, None], (*shape, 2)),
            np.broadcast_to(heights[..., None, None], (*shape, 1)),
        ],
        axis=-1,
    )
    return Boards(
        np.repeat(np.arange(count), len(layers)),
        np.tile(np.array(list(layers)), count),
        outlines.reshape(-1, levels, corners, 3),
    )


def angle_about(along: Array, one: Array, other: Array) -> Array:
    """Angles (N,) between two half planes at a line, which has the direction ``along`` (N, 3)."""
    line = _unit(along)
    first, second = (
        _unit(each - (each * line).sum(axis=1, keepdims=True) * line) for each in (one, other)
    )
    sine = np.linalg.norm(np.cross(first, second), axis=1)
    return np.asarray(np.arctan2(sine, (first * second).sum(axis=1)))


def stand_off(angle: Array, half: float, panel: float) -> Array:
    """How far (N,) a plate stands off an edge, by its angle (N,) to a panel there.

    half: Half its thickness.
    panel: Half that of the panel.
    """
    sine, cosine = np.sin(angle), np.cos(angle)
    room = sine > OFF_PLANE
    above = np.full(len(angle), np.inf)
    above[room] = (panel + half * np.abs(cosine[room])) / sine[room]
    blunt = cosine < -OFF_PLANE
    before = np.full(len(angle), np.inf)
    before[blunt] = half * sine[blunt] / -cosine[blunt]
    return np.asarray(np.maximum(np.minimum(above, before), 0.0))


def _unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


def plate_parts(
    design: Design, plates: Plates, at: Integers, shares: Array, levels: int
) -> Iterator[Part]:
    """Plates as parts, each beside the vertex of the flat sheet that it stands at.

    at: Rows and columns (G, 2) of their vertices.
    shares: What of a plate its vertex, and those above and below, bear (G, 3).
    levels: At how many heights boards have outlines.
    """
    mechanism = design.mechanism
    drive = float(np.rad2deg(mechanism.target_drive))
    places = points_of(mechanism, 0.0)[at @ [mechanism.grid.columns, 1], :2]
    flat = plates.lying() + places[:, None]
    boards = None if plates.build is None else plates.boards(places, levels)
    mesh = build_mesh(np.array([[0, 1, 2, 3]]), 4)
    for number, (name, (row, column)) in enumerate(zip(plates.names, at.tolist(), strict=True)):
        own = None
        if boards is not None:
            own = boards.chosen(boards.panels == number)
            own = replace(own, panels=np.zeros(len(own), np.int64))
        kind = name.partition(" ")[0]
        yield Part(
            title=f"{kind.capitalize()} at {row}, {column}",
            unit="unit",
            mesh=mesh,
            assignment=("B", "B", "B", "B"),
            flat=flat[number],
            fold_angles_deg=np.zeros(4),
            states=(DocumentState(plates.corners[number], np.zeros(4), drive),),
            named={SHELL: 0},
            names=(name,),
            panel=plates.build,
            boards=own,
            kind=kind,
            borne_at=np.array([(row + step, column) for step in (0, -1, 1)]),
            borne_shares=shares[number],
        )
