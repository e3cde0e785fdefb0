"""The shape of a shell as it is built: off that designed, as the shell first buckles.

That is the shape of imperfection which EN 1995-1-1, 5.4.4 (1), allows to assume.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.numerics.arrays import Array, Integers
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.mesh.sheet import CORNERS, SheetMesh
from orishell.structure.model import Model

SWAY = 0.005
"""Vertices are off by this share of the shell's height at most: EN 1995-1-1, 5.4.4 (2)."""
BOW = 0.005
"""Panels and plates bow by this share of their shorter side at most: EN 1993-1-5, table C.2."""


def usual_imperfection(linear: Equilibrium) -> float:
    """How far a shell is taken to be off its shape where nobody says so, at most (length).

    Its vertices are off as much as frames may lean, or its panels, and what stiffens
    them, as much as plates may bow, whichever comes first; 0 if it does not buckle.
    """
    if not len(linear.buckling_modes):
        return 0.0
    mode, model = linear.buckling_modes[0], linear.model
    vertices = np.linalg.norm(mode[model.mesh.nodes[:, *CORNERS]], axis=-1).max()
    limits = [SWAY * model.height / vertices] if vertices > 0 else []
    every = [_bowed(model.mesh, mode, np.zeros(0, np.int64))]
    every += [_bowed(each.own, mode[each.nodes], each.straight) for each in model.plates]
    for bows, sides in every:
        limits += (BOW * sides[bows > 0] / bows[bows > 0]).tolist()
    return float(min(limits))


def _bowed(mesh: SheetMesh, mode: Array, straight: Integers) -> tuple[Array, Array]:
    """By how much panels bow (F,) in a mode (N, 3), and their shorter sides (F,) (length).

    straight: Last corners of panels that are in the middle of a side, as those of gussets.
    """
    places, moved = mesh.facets.points[mesh.nodes], mode[mesh.nodes]
    last = np.isin(mesh.nodes[:, -1, -1], straight)[:, None]
    corner = np.where(last, (moved[:, 0, -1] + moved[:, -1, 0]) / 2, moved[:, -1, -1])
    down = np.linalg.norm(places[:, :, :1] - places[:, :1, :1], axis=-1)
    right = np.linalg.norm(places[:, :1] - places[:, :1, :1], axis=-1)
    s, t = (down / down[:, -1:])[..., None], (right / right[:, :, -1:])[..., None]
    top = moved[:, :1, :1] * (1 - t) + moved[:, :1, -1:] * t
    bottom = moved[:, -1:, :1] * (1 - t) + corner[:, None, None] * t
    bows = np.linalg.norm(moved - top * (1 - s) - bottom * s, axis=-1).max(axis=(1, 2))
    corners = places[:, *CORNERS]
    sides = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=-1)
    return bows, sides.min(axis=1)


def built_off(linear: Equilibrium, most: float) -> Model:
    """The model off its shape by so much at most (length), the way that the loads move it.

    Without stress: it was cut and joined so.
    """
    model = linear.model
    if not most or not len(linear.buckling_modes):
        return model
    mode = linear.buckling_modes[0]
    way = -1.0 if (mode * linear.displacements).sum() < 0 else 1.0
    facets, built = model.mesh.facets, replace(model)
    points = facets.points + way * most * mode
    mesh = replace(model.mesh, facets=replace(facets, points=points))
    plates = tuple(
        replace(each, own=replace(each.own, facets=replace(each.own.facets, points=own)))
        for each, own in ((each, points[each.nodes]) for each in model.plates)
    )
    vars(built).update({"mesh": mesh, "plates": plates})
    return built
