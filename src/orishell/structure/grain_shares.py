"""What panels of boards with a grain bear, by what ends it: within them, and beside creases."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.structure.crease_forces import (
    AtCrease,
    beside_one_board,
    largest_at,
    spread_forces,
)
from orishell.structure.grain import GrainStrength, grain_turns
from orishell.structure.materials import Duration
from orishell.structure.mesh.edge_forces import (
    ABOUT,
    ACROSS,
    IN_PLANE,
    NORMAL,
    EdgeForces,
    crease_sides,
    on_creases,
)
from orishell.structure.mesh.plane import tensors_along, vectors_along
from orishell.structure.mesh.stresses import PanelStresses
from orishell.structure.model import Model


@record
class GrainShares:
    """Shares of what boards with a grain bear."""

    panels: float  # of their strength
    panel_shear: float  # of boards with a grain in their plane
    rolling_shear: float  # of plies across the plane
    crease: AtCrease | None = None  # the crease at which the first is largest, if it is at one


def grain_shares(
    model: Model, patches: PanelStresses, edges: EdgeForces, duration: Duration
) -> GrainShares | None:
    """Shares of what boards with a grain bear; None if they have none.

    duration: How long loads last.
    """
    strength = model.structure.grain_strength(duration, model.site.unit)
    return None if strength is None else _by_grain(model, patches, edges, strength)


def _by_grain(
    model: Model, patches: PanelStresses, edges: EdgeForces, strength: GrainStrength
) -> GrainShares:
    inside, beside = grain_turns(model.flat, model.structure.grain)
    build, along = model.design.panel, _cosine_and_sine(inside[patches.panels])
    shares = strength.of_axes(
        tensors_along(patches.direct, *along),
        tensors_along(patches.bent, *along),
        solid=build is None or build.is_solid,
    )
    rolls = strength.rolls(vectors_along(patches.across, *along))
    found = GrainShares(
        panels=float(np.linalg.norm(shares, axis=-1).max()),
        panel_shear=float(shares[..., 2].max()),
        rolling_shear=float(rolls.max()),
    )
    beside_creases = _at_creases(model, edges)
    if beside_creases is None:
        return found
    direct, bent, across = beside_creases
    _, sides = crease_sides(model.grid)
    along = _cosine_and_sine(beside[sides[..., 0], sides[..., 1]][..., None])
    shares = strength.of_axes(
        tensors_along(direct, *along), tensors_along(bent, *along), solid=True
    )
    rolls = strength.rolls(vectors_along(across, *along))
    most = largest_at(model, np.linalg.norm(shares, axis=-1).max(axis=(1, 2)))
    return GrainShares(
        panels=max(found.panels, most.size),
        panel_shear=max(found.panel_shear, float(shares[..., 2].max())),
        rolling_shear=max(found.rolling_shear, float(rolls.max())),
        crease=most if most.size > found.panels else None,
    )


def _cosine_and_sine(angle: Array) -> tuple[Array, Array]:
    return np.cos(angle), np.sin(angle)


def _at_creases(model: Model, edges: EdgeForces) -> tuple[Array, Array, Array] | None:
    """Direct and bending stresses (C, 2, S, 3) and shear across (C, 2, S, 2) of boards at creases.

    Those square to a crease, along it and in shear. Of two boards they are of one that is left
    alone, 0 where both are; None where they depend on how hinges hold what chamfers leave.
    """
    build = model.design.panel
    board, away, one = model.thickness, 0.0, None
    if build is None or build.is_solid:
        if model.bevelled:
            return None
        values = spread_forces(model, edges)
    else:
        board = 0.5 * (build.thickness - build.membrane)
        away = 0.5 * (board + build.membrane)
        one, values = beside_one_board(model), on_creases(edges.per_length, model.grid)
    direct, bent = np.zeros((2, *values.shape[:-1], 3))
    across = np.zeros((*values.shape[:-1], 2))
    direct[..., 0], direct[..., 2] = values[..., NORMAL] / board, values[..., IN_PLANE] / board
    push = np.abs(values[..., ABOUT]) + np.abs(values[..., NORMAL]) * away
    bent[..., 0] = 6 * push / board**2
    across[..., 0] = values[..., ACROSS] / board
    if one is not None:
        direct, bent, across = (each * one[..., None] for each in (direct, bent, across))
    return direct, bent, across
