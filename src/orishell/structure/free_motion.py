"""What a free motion is, and what would hold the shell."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Literal

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.structure.model import Model
from orishell.structure.solve.active_set import respond, stands
from orishell.structure.solve.bearing import (
    GREATEST,
    driven_motion,
    needed_friction,
    with_friction,
)
from orishell.structure.solve.factorised import Factorised

STEP = 1e-5
"""Step of the drive by which the folding motion is measured (radians)."""
LARGER = 1.0, 1.1, 1.25, 1.5, 2.0, 3.0, 5.0
"""Times the least coefficient of friction that may do are tried."""
SHARE = 0.1
"""A motion that takes this share of its vertices' displacements from folding is a folding one."""


Remedy = Literal["friction", "ties", "pinned"]
"""What may hold a shell: more friction, ties between its feet, or its supports pinned."""
REMEDIES: dict[Remedy, str] = {
    "friction": "friction of {friction:g}",
    "ties": "ties between its feet",
    "pinned": "pinned supports",
}
UNFOUND = "no state of sticking and slipping feet was found in which it bears them"
Ground = Literal["slips", "lifts", "unknown"]
"""What feet do of a shell that moves: it would stand if they did not slip, or if they were held
down; or what they do was not found."""


@record
class FreeMotion:
    """A motion that the loads drive, and that nothing resists, or next to nothing."""

    displacements: Array  # of all nodes (N, 3), the largest is 1, the way that the loads drive it
    folding: bool  # whether it is the shell's own folding motion, not one of the shell as a whole
    # whether it opens the shell; it closes it otherwise. None where it is no folding motion
    opens: bool | None
    # what would hold the shell: each was tried with these loads; None if nothing was tried
    holds: tuple[Remedy, ...] | None = ()
    # whether something resists it, but so little that it goes beyond the size of the shell
    soft: bool = False
    # whether its feet slip: it would stand if they stuck. Or whether they lift, or slip because
    # others lift: it would stand if they were held down. None if neither would hold it
    ground: Ground | None = None
    # the coefficient of friction with which it stands, tried with these loads; None if none does,
    # or none was asked for
    friction: float | None = None

    def in_words(self) -> str:
        """How a shell moves under its loads, what does not hold it, and what would."""
        if self.soft:
            words = "gives way under its loads, by more than its own size: it is far too soft"
        elif self.ground == "unknown":
            words = f"may move under its loads: {UNFOUND}"
        elif self.ground == "slips":
            way = "" if not self.folding else " and opens" if self.opens else " and closes"
            words = f"slips{way} under its loads: its feet need more friction than there is"
        elif self.ground == "lifts" and not self.folding:
            words = "tips, or lifts off, under its loads: nothing holds its feet down"
        elif not self.folding:
            words = "slides or tips as a whole under its loads: its supports do not hold it"
        elif self.opens:
            words = "opens under its loads: nothing holds the feet together"
        else:
            words = "closes under its loads: nothing holds the feet apart"
        if self.holds:
            told = [REMEDIES[each].format(friction=self.friction) for each in self.holds]
            return f"{words}; {' or '.join(told)} would"
        if self.soft or self.holds is None:
            return words
        return f"{words}; neither ties between its feet nor pinned supports would"


def describe_motion(
    model: Model,
    stiffness: float,
    shape: Array,
    forces: Array,
    *,
    soft: bool = False,
    slides: bool = False,
    unknown: bool = False,
    remedies: bool = True,
) -> FreeMotion:
    """Say of a free motion what it is, and what would hold the shell: that has been tried.

    stiffness: Of creases (force per radian).
    shape: Displacements (N, 3) of nodes.
    forces: Forces (N, 3) on them.
    soft: Whether something resists it, but too little.
    slides: Whether feet slip away, though forces within their friction could bear the loads.
    unknown: Whether that could be, and what feet do was not found.
    remedies: Whether it is tried what would hold the shell.
    """
    drive = model.sheet.target_drive
    points = model.vertices(drive)
    folding = (model.vertices(drive + STEP) - model.vertices(drive - STEP)).reshape(-1)
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
    structure = model.factorised(stiffness)
    loads = structure.free_loads(forces)
    ground: Ground | None = "unknown" if unknown else "slips" if slides else None
    if not soft and ground is None and len(structure.conditions.rough):
        if driven_motion(structure, loads, "sticks") is None:
            ground = "slips"
        elif driven_motion(structure, loads, "anchored") is None:
            ground = "lifts"
    opens = part < 0 if folds else None
    if not remedies:
        return FreeMotion(shape, folds, opens, None, soft, ground)
    friction = _enough_friction(structure, loads, model.size) if ground == "slips" else None
    holds: tuple[Remedy, ...] = tuple(
        name
        for name, other in _remedies(model, stiffness).items()
        if stands(other, respond(other, other.free_loads(forces)), model.size)
    )
    if friction is not None:
        holds = ("friction", *holds)
    return FreeMotion(shape, folds, opens, holds, soft, ground, friction)


def _enough_friction(structure: Factorised, loads: Array, size: float) -> float | None:
    """A coefficient of friction of two digits with which it stands, tried; None if none was found.

    The first is the least with which feet can bear the loads. Feet may slip away all the same, if
    nothing makes them press as they would have to; so larger ones are tried, too.
    """
    least = needed_friction(structure, loads)
    if least is None:
        return None
    now = float(structure.conditions.friction.max())
    for more in LARGER:
        asked = max(least, now) * more
        step = 10.0 ** (math.floor(math.log10(asked)) - 1)
        tried = float(f"{math.ceil(round(asked / step, 6)) * step:.2g}")
        if tried > GREATEST:
            return None
        rougher = with_friction(structure, tried)
        if stands(rougher, respond(rougher, loads), size):
            return tried
    return None


def _remedies(model: Model, stiffness: float) -> dict[Remedy, Factorised]:
    """The shell with those things that it lacks and that may hold it."""
    asked, site = model.structure, model.site
    pinned = tuple(each.replace_unchecked(kind="pinned", friction=0.0) for each in asked.supports)
    tried: dict[Remedy, Model] = {
        "pinned": replace(model, structure=asked.replace_unchecked(supports=pinned))
    }
    if site.feet is not None and not site.ties:
        columns = np.arange(model.grid.columns)[model.sheet.inner_columns] + model.before
        if site.feet.points:
            columns = site.feet.columns(model.sheet)
        first, last = site.feet.rows
        ties = tuple(((first, column), (last, column)) for column in columns.tolist())
        tried = {"ties": replace(model, site=replace(site, ties=ties)), **tried}
    return {name: other.factorised(stiffness) for name, other in tried.items()}
