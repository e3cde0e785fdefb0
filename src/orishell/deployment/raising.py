"""What it takes to bring a shell to its target by hand: work, forces and people, by stages.

By virtual work, with V the potential energy of the panels over the feet: while the feet move by dL
along their way, and the row that is highest at the target rises by dz over them,

    force = dV/dL,        lift = dV/dz,

each of them alone. They grow beyond all bounds where feet, or the row, come to rest.
"""

from __future__ import annotations

from math import ceil

import numpy as np

from orishell.conventions.quantities import GRAVITY, PERSON_KG
from orishell.conventions.record import Angle, record
from orishell.deployment.fixings import Fixings
from orishell.deployment.weight import Body, OwnWeight
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_largest

PERSON = PERSON_KG * GRAVITY
"""What one person can lift, and is taken to pull (N)."""
STAGES = 4
"""The way has so many parts, of the same change of the drive."""
STEP = 1e-3
"""Differences are taken over this share of the way."""
AT_REST = 1e-10
"""A row that moves by less than this share of the sheet's size over half a step is at rest."""


@record
class Stage:
    """A state on the way, and what moves the shell on from there."""

    REPORTED = ("drive", "work", "force", "people", "lift", "lifting_people")

    drive: Angle
    work: float  # what it takes to get there (force times metres)
    # force on all feet of either side along their way; negative where they must be held back, None
    # where none moves the shell
    force: float | None
    # upward force on the row that is highest at the target, negative and None likewise
    lift: float | None
    known: bool  # whether forces are in newtons

    @property
    def people(self) -> int | None:
        """How many people have that force, on either side; None where it or the mass is unknown."""
        return _people(self.force) if self.known else None

    @property
    def lifting_people(self) -> int | None:
        """How many people lift with that force; None likewise."""
        return _people(self.lift) if self.known else None


@record
class Raising:
    """The way of a shell from flat or packed to its target, by its own weight."""

    REPORTED = ("row", "person", "stages")

    row: int  # the row of vertices that is highest at the target: where it is lifted
    person: float  # what one person is taken to pull or lift (N)
    stages: tuple[Stage, ...]  # from where it begins to the target


def _people(force: float | None) -> int | None:
    return None if force is None else ceil(abs(force) / PERSON)


def find_raising(body: Body, weight: OwnWeight, end: float, metres: float) -> Raising:
    """What it takes to bring a shell to its target from a drive, flat or packed.

    Parameters
    ----------
    weight
        Its own weight, as it was measured of the same body.
    end
        The drive (radians).
    metres
        The unit of length, for work (m).
    """
    target = body.mechanism.target_drive
    inner = body.mechanism.positions(target)[:, body.standing.feet.columns, 2]
    row = first_largest(inner.mean(axis=1))
    lifted = _row_fixings(body, row)
    known = weight.force_unit == "N"
    unit = 1.0 if known else body.weight * float(body.shares.sum())
    drives = np.linspace(end, target, STAGES + 1)
    works = _works(body, np.array(weight.drives), weight.energy * unit, drives)
    step, stages = STEP * (target - end), []
    thrusts = body.thrusts(drives).tolist()
    for number, (drive, work, thrust) in enumerate(
        zip(drives.tolist(), works, thrusts, strict=True)
    ):
        lift, grows = _moved(body, lifted, drive, -step if number else step)
        # Where the span grows on the way, feet are pulled apart.
        force = None if np.isnan(thrust) else -thrust * grows * float(np.sign(step)) / unit
        up = None if lift is None else lift / unit
        stages.append(Stage(drive, work * metres / unit, force, up, known))
    return Raising(row, PERSON, tuple(stages))


def _works(body: Body, drives: Array, energy: Array, stages: Array) -> list[float]:
    """The sum of all rises of the energy from the first stage (N,) to each.

    By the energy (S,) that is known at drives (S,) between them.
    """
    at_stages, _ = body.at(stages)
    low, high = min(stages[0], stages[-1]), max(stages[0], stages[-1])
    between = (drives > low) & (drives < high)
    path = np.concatenate([stages, drives[between]])
    found = np.concatenate([at_stages, energy[between]])
    order = np.argsort(path if stages[-1] >= stages[0] else -path, kind="stable")
    climbed = np.concatenate([[0.0], np.cumsum(np.maximum(np.diff(found[order]), 0.0))])
    place = np.empty(len(path), np.int64)
    place[order] = np.arange(len(path))
    return [float(each) for each in climbed[place[: len(stages)]]]


def _moved(body: Body, feet: Fixings, drive: float, step: float) -> tuple[float | None, float]:
    """The lift of the row of ``feet`` (force), and 1 or -1: whether the span grows with the drive.

    By differences over a step and half of it, to one side, so that it serves where all are at rest.
    """
    drives = drive + step * np.array([0.0, 0.5, 1.0])
    energy, span = body.at(drives)
    seen = body.standing.place(drives).seen(feet.at(drives)[:, :, 0])
    climb, height = np.diff(energy), np.diff(seen[..., 2].mean(axis=1))
    climb, height = np.cumsum(climb), np.cumsum(height)
    grows = float(np.sign((span[2] - span[0]) / step))
    if np.abs(height).min() <= AT_REST * body.standing.size:
        return None, grows
    half, whole = (climb / height).tolist()
    return 2 * half - whole, grows


def _row_fixings(body: Body, row: int) -> Fixings:
    """Where a row of vertices is, or the boards of panels at it: the first of each pair."""
    feet = body.standing.feet
    other = row - 1 if row else 1
    rows = np.broadcast_to([row, other], (len(feet.columns), 2))
    return Fixings(body.mechanism, rows, feet.columns, feet.hinges)
