"""Plates that stiffen a sheet: what they bear, and what they add as they turn under it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Vertex
from orishell.numerics.arrays import Array
from orishell.numerics.equals import SOLVED, first_largest
from orishell.structure.materials import Duration
from orishell.structure.mesh.corotational import Corotational
from orishell.structure.mesh.geometric import geometric_stiffness
from orishell.structure.mesh.plates import Plates
from orishell.structure.mesh.stresses import (
    FacetForces,
    PanelStresses,
    facet_stresses,
    panel_stresses,
    von_mises,
)
from orishell.structure.model import Model
from orishell.structure.settings import Structure
from orishell.structure.utilisation import share_of

if TYPE_CHECKING:
    from scipy.sparse import csr_array


@record
class PlateStress:
    """The largest stress in plates that stiffen a sheet."""

    size: float  # von Mises' stress, averaged over a patch of a fixed share of a plate
    at: Vertex  # the vertex that the plate goes from


def plate_forces(model: Model, corners: Array | None) -> FacetForces | None:
    """What triangles of plates bear; None if there are no plates.

    corners: Displacements and rotations (T', 18) of their corners; None if there are no plates.
    """
    if model.plates is None or corners is None:
        return None
    return facet_stresses(model.plates.own.facets, model.plate_section, corners)


def stresses_in_plates(model: Model, borne: FacetForces | None) -> PanelStresses | None:
    """Stresses of plates by patches; None if there are no plates."""
    if model.plates is None or borne is None:
        return None
    return panel_stresses(model.plates.own, model.plate_section, borne)


def most_stressed(model: Model, stresses: PanelStresses | None) -> PlateStress | None:
    """The plate with the largest stress; None if there are no plates."""
    if stresses is None:
        return None
    sizes = stresses.von_mises().max(axis=1)[np.unique(stresses.patches, return_index=True)[1]]
    patch = first_largest(sizes, SOLVED)
    number = int(stresses.panels[np.unique(stresses.patches)[patch]])
    part = model.design.plates[number]
    assert part.plate is not None
    return PlateStress(float(sizes[patch]), part.plate.corner)


def used_of_plates(
    structure: Structure, stresses: PanelStresses | None, duration: Duration, unit: str
) -> float | None:
    """The share of their strength that plates use at most; None if it is not known, or without any.

    Which way their grain runs, where they have one, is not known. With f the least strength of a
    board along or across it, and f_v in panel shear, the share of both is the root of
    (s_1^2 + s_2^2)/f^2 + t^2/f_v^2. The first sum is no more than 2 (s_1^2 - s_1 s_2 + s_2^2), so
    the share is no more than von Mises' stress over the less of f/sqrt(2) and sqrt(3) f_v: of what
    both faces have, and of what bending adds.
    """
    if stresses is None:
        return None
    grain = structure.grain_strength(duration, unit)
    if grain is None:
        return share_of(float(stresses.von_mises().max()), structure.bears(duration, unit))
    weaker = grain.weaker()
    least = min(*weaker.bending, *weaker.tension, *weaker.compression)
    bears = min(least / np.sqrt(2), np.sqrt(3) * weaker.panel_shear)
    together = von_mises(stresses.direct) + von_mises(stresses.bent)
    return float(max((together / bears).max(), weaker.rolls(stresses.across).max()))


def turned_plates(plates: Plates, borne: FacetForces, count: int) -> csr_array:
    """What plates that turn under membrane forces add to the stiffness of all dofs (D, D).

    As in panels, but that displacements are linear in triangles at the middle of a plate's outer
    side: nodes in a row say nothing of slopes there, where both rows are one line.
    """
    from scipy.sparse import bsr_array, coo_array, csr_array

    own = plates.own
    every, none = np.arange(own.count), csr_array((own.count, own.count))
    turned = geometric_stiffness(own, borne.forces, own.nodes[:, -1, -1], every, none)
    slopes = turned.slopes + turned.curved * np.repeat(turned.bent, 6)[:, None]
    blocks = np.repeat(turned.weights, 3, axis=0)
    number = np.arange(len(blocks) + 1)
    by_own = coo_array(slopes.T @ bsr_array((blocks, number[:-1], number)) @ slopes)
    places = plates.dofs[by_own.row], plates.dofs[by_own.col]
    return csr_array(coo_array((by_own.data, places), shape=(count, count)))


def movable_plates(model: Model) -> list[Corotational]:
    """Plates as they may be moved far, their rotations behind those of panels; none without any."""
    plates, mesh = model.plates, model.mesh
    if plates is None:
        return []
    own, dofs = plates.own, plates.dofs[plates.own.dofs()]
    return [Corotational.of(own.facets, model.plate_section, dofs, mesh.nodes.size + own.places)]
