"""What moves where nothing holds a shell: the shell as a whole, or its folding motion."""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array
from orishell.structure.model import Model
from orishell.structure.results import FreeMotion

STEP = 1e-5
"""Step of the drive by which the folding motion is measured (radians)."""
SHARE = 0.1
"""A motion that takes this share of its vertices' displacements from folding is a folding one."""


def describe_motion(model: Model, shape: Array) -> FreeMotion:
    """Say of a free motion (N, 3) what it is."""
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
    return FreeMotion(shape, folds, part < 0 if folds else None)
