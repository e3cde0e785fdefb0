"""What stiffens a sheet, plates and strips: what it bears, and what it adds as it turns under it.

Plates that are made alike are meshed together: gussets all at once, strips of box girders one by
one, and the plates across each. What is found has one entry for each mesh of ``Model.plates``.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Vertex
from orishell.numerics.arrays import Array
from orishell.numerics.equals import SOLVED, first_largest
from orishell.structure.carried import names_of
from orishell.structure.materials import Duration
from orishell.structure.mesh.corotational import Corotational
from orishell.structure.mesh.geometric import geometric_stiffness
from orishell.structure.mesh.parts import Plates
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


@record
class BoxStress:
    """The largest stress in box girders."""

    size: float  # von Mises' stress, averaged over a patch of a fixed share of a panel
    part: str  # which panel of which strip, "box 4 upper 3", or which plate across: "plate 4,3"


def stiffener_names(model: Model) -> tuple[str, ...]:
    """What each of what stiffens the sheet is called, in the order of ``Model.plates``."""
    return names_of(model.design) or tuple(part.names[0] for part in model.design.plates)


def plate_forces(model: Model, corners: Sequence[Array]) -> tuple[FacetForces, ...]:
    """What triangles of plates bear.

    corners: Displacements and rotations (T', 18) of their corners.
    """
    return tuple(
        facet_stresses(each.own.facets, section, moved)
        for each, section, moved in zip(
            model.plates, model.stiffened.sections, corners, strict=True
        )
    )


def stresses_in_plates(model: Model, borne: Sequence[FacetForces]) -> tuple[PanelStresses, ...]:
    """Stresses of plates by patches."""
    return tuple(
        panel_stresses(each.own, section, found)
        for each, section, found in zip(model.plates, model.stiffened.sections, borne, strict=True)
    )


def most_stressed(model: Model, stresses: Sequence[PanelStresses]) -> PlateStress | None:
    """The gusset with the largest stress; None if there are none."""
    if not model.design.plates or not stresses:
        return None
    size, number = _largest(stresses)
    part = model.design.plates[number]
    assert part.plate is not None
    return PlateStress(size, part.plate.corner)


def most_stressed_box(model: Model, stresses: Sequence[PanelStresses]) -> BoxStress | None:
    """The panel or plate of box girders with the largest stress; None if there are none."""
    if not model.design.carried or not stresses:
        return None
    size, number = _largest(stresses)
    return BoxStress(size, names_of(model.design)[number])


def _largest(stresses: Sequence[PanelStresses]) -> tuple[float, int]:
    """The largest stress, and the plate that has it, all of them numbered one after the other."""
    sizes, numbers, before = [], [], 0
    for each in stresses:
        patches, where = np.unique(each.patches, return_index=True)
        sizes.append(each.von_mises().max(axis=1)[where])
        numbers.append(before + each.panels[patches])
        before += int(each.panels[-1]) + 1
    every = np.concatenate(sizes)
    most = first_largest(every, SOLVED)
    return float(every[most]), int(np.concatenate(numbers)[most])


def used_of_plates(
    structure: Structure, stresses: Sequence[PanelStresses], duration: Duration, unit: str
) -> float | None:
    """The share of their strength that plates use at most; None if it is not known, or without any.

    Which way their grain runs, where they have one, is not known. With f the least strength of a
    board along or across it, and f_v in panel shear, the share of both is the root of
    (s_1^2 + s_2^2)/f^2 + t^2/f_v^2. The first sum is no more than 2 (s_1^2 - s_1 s_2 + s_2^2), so
    the share is no more than von Mises' stress over the less of f/sqrt(2) and sqrt(3) f_v: of what
    both faces have, and of what bending adds.
    """
    if not stresses:
        return None
    grain = structure.grain_strength(duration, unit)
    if grain is None:
        most = max(float(each.von_mises().max()) for each in stresses)
        return share_of(most, structure.bears(duration, unit))
    weaker = grain.weaker()
    least = min(*weaker.bending, *weaker.tension, *weaker.compression)
    bears = min(least / np.sqrt(2), np.sqrt(3) * weaker.panel_shear)
    return float(
        max(
            max(
                ((von_mises(each.direct) + von_mises(each.bent)) / bears).max(),
                weaker.rolls(each.across).max(),
            )
            for each in stresses
        )
    )


def turned_plates(plates: Plates, borne: FacetForces, count: int) -> csr_array:
    """What plates that turn under membrane forces add to the stiffness of all dofs (D, D).

    As in panels, but that displacements are linear in triangles where a corner of a plate is a
    straight angle, as in the middle of a gusset's outer side: nodes in a row say nothing of slopes
    there, where both rows are one line.
    """
    from scipy.sparse import bsr_array, coo_array, csr_array

    own = plates.own
    every, none = np.arange(own.count), csr_array((own.count, own.count))
    turned = geometric_stiffness(own, borne.forces, plates.straight, every, none)
    slopes = turned.slopes + turned.curved * np.repeat(turned.bent, 6)[:, None]
    blocks = np.repeat(turned.weights, 3, axis=0)
    number = np.arange(len(blocks) + 1)
    by_own = coo_array(slopes.T @ bsr_array((blocks, number[:-1], number)) @ slopes)
    places = plates.dofs[by_own.row], plates.dofs[by_own.col]
    return csr_array(coo_array((by_own.data, places), shape=(count, count)))


def movable_plates(model: Model) -> list[Corotational]:
    """Plates as they may be moved far, their rotations behind those of panels."""
    panels = model.mesh.nodes.size
    return [
        Corotational.of(
            each.own.facets,
            section,
            each.dofs[each.own.dofs()],
            panels + each.first + each.own.places,
        )
        for each, section in zip(model.plates, model.stiffened.sections, strict=True)
    ]
