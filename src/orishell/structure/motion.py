"""What moves where nothing holds a shell: the shell as a whole, or its folding motion."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.numerics.arrays import Array
from orishell.structure.acting import respond
from orishell.structure.model import Model
from orishell.structure.results import FreeMotion, Hold
from orishell.structure.settings import Support

STEP = 1e-5
"""Step of the drive by which the folding motion is measured (radians)."""
SHARE = 0.1
"""A motion that takes this share of its vertices' displacements from folding is a folding one."""


def describe_motion(model: Model, shape: Array, forces: Array, *, soft: bool = False) -> FreeMotion:
    """Say of a free motion what it is, and what would hold the shell: that has been tried.

    Parameters
    ----------
    shape
        Displacements (N, 3) of nodes.
    forces
        Forces (N, 3) on them.
    soft
        Whether something resists it, but too little.
    """
    drive, points = model.sheet.target_drive, model.positions.reshape(-1, 3)
    near = model.sheet.positions(np.array([drive - STEP, drive + STEP]))
    folding = (near[1] - near[0]).reshape(-1)
    away = points - points.mean(axis=0)
    whole = np.concatenate(
        [np.tile(np.eye(3), (len(points), 1, 1)), np.cross(away[:, None], np.eye(3))], axis=1
    )
    rigid = np.linalg.qr(whole.transpose(0, 2, 1).reshape(-1, 6))[0]
    folding -= rigid @ (rigid.T @ folding)
    folding /= np.linalg.norm(folding)
    found = shape[: len(points)].reshape(-1)
    part = float(folding @ found)
    folds = abs(part) > SHARE * float(np.linalg.norm(found))
    holds = _holds(model, forces)
    return FreeMotion(shape, folds, part < 0 if folds else None, holds, soft)


def _holds(model: Model, forces: Array) -> tuple[Hold, ...]:
    """What would hold a shell of those things that it lacks."""
    structure, frame = model.structure, model.frame
    pinned = tuple(Support(at=each.at, kind="pinned") for each in structure.supports)
    tried: dict[Hold, Model] = {
        "pinned": replace(model, structure=structure.having(supports=pinned))
    }
    if frame.feet is not None and not frame.ties:
        inner = model.sheet.inner_columns
        columns = np.arange(model.grid.columns)[inner] + model.before
        first, last = frame.feet
        ties = tuple(((first, column), (last, column)) for column in columns.tolist())
        tried = {"ties": replace(model, frame=replace(frame, ties=ties)), **tried}
    return tuple(name for name, other in tried.items() if _stands(other, forces))


def _stands(model: Model, forces: Array) -> bool:
    response = respond(model.held, model.free_loads(forces))
    return response.moves is None and model.furthest(response.displacements) <= model.size
