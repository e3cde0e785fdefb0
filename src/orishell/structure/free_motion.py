"""What a free motion is, and what would hold the shell."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.numerics.arrays import Array
from orishell.structure.model import Model
from orishell.structure.results import FreeMotion, Remedy
from orishell.structure.solve.active_set import respond, stands
from orishell.structure.solve.factorised import Factorised

STEP = 1e-5
"""Step of the drive by which the folding motion is measured (radians)."""
SHARE = 0.1
"""A motion that takes this share of its vertices' displacements from folding is a folding one."""


def describe_motion(
    model: Model, stiffness: float, shape: Array, forces: Array, *, soft: bool = False
) -> FreeMotion:
    """Say of a free motion what it is, and what would hold the shell: that has been tried.

    stiffness: Of creases (force per radian).
    shape: Displacements (N, 3) of nodes.
    forces: Forces (N, 3) on them.
    soft: Whether something resists it, but too little.

    Raises VerificationError: If no set of ties, flaps and feet fits the loads: a fault of the
    program.
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
    holds = tuple(
        name
        for name, other in _remedies(model, stiffness).items()
        if stands(other, respond(other, other.free_loads(forces)), model.size)
    )
    return FreeMotion(shape, folds, part < 0 if folds else None, holds, soft)


def _remedies(model: Model, stiffness: float) -> dict[Remedy, Factorised]:
    """The shell with those things that it lacks and that may hold it."""
    asked, site = model.structure, model.site
    pinned = tuple(each.having(kind="pinned", friction=0.0) for each in asked.supports)
    tried: dict[Remedy, Model] = {"pinned": replace(model, structure=asked.having(supports=pinned))}
    if site.rows is not None and not site.ties:
        inner = model.sheet.inner_columns
        columns = np.arange(model.grid.columns)[inner] + model.before
        first, last = site.rows
        ties = tuple(((first, column), (last, column)) for column in columns.tolist())
        tried = {"ties": replace(model, site=replace(site, ties=ties)), **tried}
    return {name: other.factorised(stiffness) for name, other in tried.items()}
