"""Feet on the ground: which stick, slip or lift, and how far."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Vertex
from orishell.structure.mesh.corotational import Moved
from orishell.structure.solve.active_set import Response
from orishell.structure.solve.contacts import Feet
from orishell.structure.solve.factorised import Factorised

AT_LIMIT = 1e-6
"""Feet of a shell that is moved far slip if they use all of their friction but this share."""


@record
class Foot:
    """A foot on the ground, which pushes and rubs, and does not pull."""

    REPORTED = ("at", "state", "slip", "slipped", "gap", "used")

    at: Vertex  # the vertex
    state: Literal["sticks", "slips", "lifted"]  # what it does
    slip: tuple[float, float]  # how far it slips, along x and y
    gap: float  # how far it is lifted
    used: (
        float | None
    )  # the share of its friction that it uses; None without, or where it is lifted

    @property
    def slipped(self) -> float:
        """How far it slips."""
        return float(np.hypot(*self.slip))


def find_feet(
    structure: Factorised, response: Response, vertices: Sequence[Vertex]
) -> tuple[Foot, ...]:
    """What feet on the ground do.

    vertices: Those that stand on the ground, in the order of their conditions.
    """
    conditions, count = structure.conditions, len(structure.conditions)
    grounded, rough = np.flatnonzero(conditions.grounded), conditions.rough
    slips, rubs = (np.zeros((count, 2)) for _ in range(2))
    rows = slice(count, count + 2 * len(rough))
    slips[rough] = response.parted[rows].reshape(-1, 2)
    rubs[rough] = response.forces[rows].reshape(-1, 2)
    limit = conditions.friction * response.forces[:count]
    found = []
    for at, row in zip(vertices, grounded.tolist(), strict=True):
        presses = bool(response.active[row])
        slip = slips[row] if presses else np.zeros(2)
        slides = bool(slip.any())
        used = None
        if presses and limit[row] > 0:
            used = 1.0 if slides else float(np.linalg.norm(rubs[row]) / limit[row])
        found.append(
            Foot(
                at=at,
                state="slips" if slides else "sticks" if presses else "lifted",
                slip=(float(slip[0]), float(slip[1])),
                gap=0.0 if presses else float(max(-response.parted[row], 0.0)),
                used=used,
            )
        )
    return tuple(found)


def moved_feet(part: Feet, moved: Moved, vertices: Sequence[Vertex]) -> tuple[Foot, ...]:
    """What feet of a shell that is moved far do; a foot that slips has been moved as far.

    vertices: Those that stand on the ground, in the order of the part.
    """
    presses, gaps = part.bears(moved), part.gaps(moved)
    limits = part.friction * presses
    rubs = np.linalg.norm(part.forces(moved)[:, :2], axis=1)
    places = moved.displacements[part.dofs[:, :2]]
    found = []
    for number, at in enumerate(vertices):
        limit, bears = float(limits[number]), bool(presses[number] > 0)
        slides = bears and bool(rubs[number] >= (1 - AT_LIMIT) * limit)
        slip = places[number] if slides else np.zeros(2)
        found.append(
            Foot(
                at=at,
                state="slips" if slides else "sticks" if bears else "lifted",
                slip=(float(slip[0]), float(slip[1])),
                gap=0.0 if bears else float(max(-gaps[number], 0.0)),
                used=float(rubs[number] / limit) if limit > 0 else None,
            )
        )
    return tuple(found)
