"""The model of a shell as it may be moved far: panels, creases, ties, flaps and feet."""

from __future__ import annotations

import numpy as np

from orishell.structure.mesh.corotational import Corotational
from orishell.structure.mesh.frames import SlightlyMoved
from orishell.structure.mesh.hinges import Folds, crease_springs, rigid_stiffness
from orishell.structure.model import Model
from orishell.structure.plates import movable_plates
from orishell.structure.solve.active_set import Response
from orishell.structure.solve.contacts import Feet, Links
from orishell.structure.solve.moving import Moving
from orishell.structure.solve.path import TOUCHING

PENALTY, STEADY = 100.0, 1e-9
"""What does not give has this stiffness by that of nodes, until it is taken over; motions that
nothing drives have the other."""


def movable(model: Model, stiffness: float, response: Response) -> Moving:
    """The model, with creases of a stiffness (force per radian), as it may be moved far.

    response: What loads do by linear theory: who touches at the start.
    """
    mesh, points = model.mesh, model.mesh.facets.points
    translations, lever = mesh.translations(), float(np.sqrt(mesh.facets.areas().mean()))
    panels = Corotational.of(mesh.facets, model.section, mesh.dofs(), mesh.places)
    parts: list[Corotational | Folds | SlightlyMoved | Links | Feet]
    parts = [panels, *movable_plates(model)]
    if stiffness:
        least = min(stiffness, rigid_stiffness(mesh, model.section))
        parts.append(Folds(*crease_springs(mesh, model.grid, least)))
    parts.extend(rail.moving() for rail in model.rails)
    diagonal = np.einsum("tii->ti", panels.stiffness).reshape(-1, 3, 6)[..., :3]
    typical = float(diagonal.sum() / (3 * len(points)))
    ties, flaps = model.nodes_of(model.site.ties), model.nodes_of(model.flaps)
    pairs, ground = np.concatenate([ties, flaps]), model.supports.ground
    bears = TOUCHING * np.maximum(response.forces, 0.0)
    if len(pairs):
        tie = np.arange(len(pairs)) < len(ties)
        length = np.linalg.norm(points[pairs[:, 1]] - points[pairs[:, 0]], axis=1)
        own = model.structure.tie_stiffness / length
        hard = ~tie | ~np.isfinite(own)
        parts.append(
            Links(
                points=points[pairs],
                dofs=translations[pairs].reshape(-1, 6),
                sign=np.where(tie, 1.0, -1.0),
                stiffness=np.where(hard, PENALTY * typical, own),
                hard=hard,
                borne=bears[: len(pairs)],
            )
        )
    if len(ground):
        stood, rubbed = np.zeros((2, len(ground), 2))
        normal, rubs = np.split(response.forces[len(pairs) :], [len(ground)])
        friction = model.supports.friction
        rough = np.flatnonzero(friction)
        rubbed[rough] = TOUCHING * rubs[: 2 * len(rough)].reshape(-1, 2)
        parts.append(
            Feet(
                dofs=translations[ground],
                stiffness=PENALTY * typical,
                friction=friction,
                borne=TOUCHING * np.maximum(normal, 0.0),
                rubbed=rubbed,
                stood=stood,
            )
        )
    spins = [mesh.rotations().reshape(-1, 3), *(each.turns for each in model.plates)]
    loose = len(pairs) or len(ground) or not stiffness or response.motions.shape[1]
    return Moving.of(
        parts,
        model.supports.dofs(mesh),
        np.concatenate(spins),
        lever,
        steady=STEADY * typical if loose else 0.0,
    )
