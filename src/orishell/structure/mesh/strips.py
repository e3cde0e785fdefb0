"""Strips beside the creases of a sandwich, where one board is left or only the membrane is.

At a crease nothing but the membrane goes from panel to panel. It bears a pull N and a shear V_in
per length over its thickness t as a film does, by the larger principal stress,

    (N/2 + sqrt((N/2)^2 + V_in^2))/t;

push it does not bear at all. Beside the crease that side of a panel that closes has its board
further back than the other: there one board alone, of thickness b and with its middle d away from
the hinge plane, has

    sigma = N/b + 6 (M + N d)/b^2,    tau = V_in/b.

A solid board of thickness t is chamfered where it closes. Right beside the crease one half of it is
left, b = t/2 and d = t/4; where there is no chamfer, b = t and d = 0. From there a chamfer leads to
the face, so that a board has the less bending stiffness the wider its chamfers are.
"""

from __future__ import annotations

import numpy as np

from orishell.design import PanelSpec
from orishell.motion.boards import Boards
from orishell.numerics.arrays import Array, Booleans
from orishell.structure.mesh.edge_forces import ABOUT, IN_PLANE, NORMAL
from orishell.structure.mesh.layup import Layup
from orishell.structure.mesh.sections import inwards, set_back

EQUAL = 1e-6
"""Set-backs that differ by less than this share of the longest edge are equal."""


def film_stress(per_length: Array, build: PanelSpec) -> Array:
    """Largest principal stress (...) of the membrane in a crease (force per area).

    per_length: N, V_in, V, M (..., 4).
    """
    half, shear = 0.5 * per_length[..., NORMAL], per_length[..., IN_PLANE]
    return np.asarray((half + np.hypot(half, shear)) / build.membrane)


def board_stress(per_length: Array, build: PanelSpec, layup: Layup) -> Array:
    """Largest stress (...) by von Mises of a board that is alone beside a crease (force per area).

    per_length: N, V_in, V, M (..., 4).
    """
    board = 0.5 * (build.thickness - build.membrane)
    away = 0.5 * (board + build.membrane)
    return _outermost(per_length, layup, board, away)


def solid_stress(per_length: Array, thickness: float, layup: Layup) -> Array:
    """Largest stress (...) by von Mises of a solid board beside a crease (force per area).

    per_length: N, V_in, V, M (..., 4).
    """
    return _outermost(per_length, layup, thickness, 0.0)


def _outermost(per_length: Array, layup: Layup, thickness: float, away: float) -> Array:
    """Von Mises' stress (...) of the outermost fibres, N being so far away from the middle."""
    size = np.abs(per_length)
    moment = size[..., ABOUT] + size[..., NORMAL] * away
    direct, bent = layup.stresses(thickness, size[..., NORMAL], moment)
    shear, _ = layup.stresses(thickness, size[..., IN_PLANE], moment)
    return np.asarray(np.sqrt((direct + bent) ** 2 + 3 * shear**2))


def one_board(boards: Boards, flat: Array) -> Booleans:
    """Beside which edges (F, 4) of panels one board is alone.

    flat: Corners (F, 4, 2) of the panels in the flat sheet, counter-clockwise.
    """
    _, length = inwards(flat)
    both = [set_back(boards.chosen(boards.sides == side), flat, 0) for side in (1, -1)]
    back = np.stack(both, axis=-1)
    there = np.isfinite(back)
    back[~there] = 0.0
    differ = np.abs(back[..., 0] - back[..., 1]) > EQUAL * length.max()
    return np.asarray(there.any(axis=-1) & (differ | ~there.all(axis=-1)))


def chamfered(boards: Boards, flat: Array) -> Booleans:
    """Beside which edges (F, 4) of panels a solid board is chamfered, on either face.

    flat: Corners (F, 4, 2) of the panels in the flat sheet, counter-clockwise.
    """
    _, length = inwards(flat)
    low, middle, top = (set_back(boards, flat, level) for level in range(3))
    found = np.zeros(flat.shape[:2], dtype=bool)
    there = boards.panels
    found[there] = np.maximum(low, top)[there] - middle[there] > EQUAL * length.max()
    return found
