"""Strips beside the creases of a sandwich, where one board is left or only the membrane is.

At a crease nothing but the membrane goes from panel to panel. It bears a pull N and a shear V_in
per length over its thickness t as a film does, by the larger principal stress,

    (N/2 + sqrt((N/2)^2 + V_in^2))/t;

push it does not bear at all. Beside the crease that side of a panel that closes has its board
further back than the other: there one board alone, of thickness b and with its middle d away from
the hinge plane, has

    sigma = N/b + 6 (M + N d)/b^2,    tau = V_in/b.
"""

from __future__ import annotations

import numpy as np

from orishell.design import PanelSpec
from orishell.motion.boards import Boards
from orishell.numerics.arrays import Array, Booleans
from orishell.structure.mesh.edge_forces import ABOUT, IN_PLANE, NORMAL

EQUAL = 1e-6
"""Set-backs that differ by less than this share of the longest edge are equal."""


def film_stress(per_length: Array, build: PanelSpec) -> Array:
    """Largest principal stress (...) of the membrane in a crease (force per area).

    per_length: N, V_in, V, M (..., 4).
    """
    half, shear = 0.5 * per_length[..., NORMAL], per_length[..., IN_PLANE]
    return np.asarray((half + np.hypot(half, shear)) / build.membrane)


def board_stress(per_length: Array, build: PanelSpec) -> Array:
    """Largest stress (...) by von Mises of a board that is alone beside a crease (force per area).

    per_length: N, V_in, V, M (..., 4).
    """
    board = 0.5 * (build.thickness - build.membrane)
    away = 0.5 * (board + build.membrane)
    size = np.abs(per_length)
    direct = size[..., NORMAL] / board
    bent = 6 * (size[..., ABOUT] + size[..., NORMAL] * away) / board**2
    return np.asarray(np.sqrt((direct + bent) ** 2 + 3 * (size[..., IN_PLANE] / board) ** 2))


def one_board(boards: Boards, flat: Array) -> Booleans:
    """Beside which edges (F, 4) of panels one board is alone.

    flat: Corners (F, 4, 2) of the panels in the flat sheet, counter-clockwise.
    """
    along = np.roll(flat, -1, axis=1) - flat
    length = np.linalg.norm(along, axis=-1)
    inwards = np.stack([-along[..., 1], along[..., 0]], axis=-1) / length[..., None]
    back = np.full((*flat.shape[:2], 2), np.inf)
    for place, side in enumerate((1, -1)):
        own = boards.chosen(boards.sides == side)
        away = own.outlines[:, 0, None, :, :2] - flat[own.panels][:, :, None]
        back[own.panels, :, place] = np.einsum("bskx,bsx->bsk", away, inwards[own.panels]).min(
            axis=-1
        )
    there = np.isfinite(back)
    back[~there] = 0.0
    differ = np.abs(back[..., 0] - back[..., 1]) > EQUAL * length.max()
    return np.asarray(there.any(axis=-1) & (differ | ~there.all(axis=-1)))
