"""What the core and the faces of sandwich boards bear beside their strength."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.structure.crease_forces import spread_forces
from orishell.structure.mesh.edge_forces import ABOUT, ACROSS, IN_PLANE, NORMAL, EdgeForces
from orishell.structure.mesh.stresses import PanelStresses
from orishell.structure.model import Model


@record
class InSandwich:
    """The largest stresses that end what a sandwich bears, strength of faces apart."""

    core_shear: float  # of the core across the board (force per area)
    pressure: float  # of faces, the least principal stress (force per area)
    wrinkling: float  # the pressure at which they wrinkle (force per area)


def in_sandwich(model: Model, patches: PanelStresses, edges: EdgeForces) -> InSandwich | None:
    """What there is in boards with a core; None if they have none.

    By patches, and of one board alone that is not chamfered by the forces beside creases, too.
    """
    layup, build = model.structure.layup, model.design.panel
    wrinkling = layup.wrinkling
    if wrinkling is None:
        return None
    shear = float(np.linalg.norm(patches.across, axis=1).max())
    pressure = max(0.0, -float(patches.principal()[:, 1].min()))
    if not model.bevelled and (build is None or build.is_solid):
        thickness, values = model.thickness, spread_forces(model, edges)
        across = np.abs(values[..., ACROSS]) / float(layup.depth(thickness))
        push = np.maximum(-values[..., NORMAL], 0.0)
        direct, bent = layup.stresses(thickness, push, np.abs(values[..., ABOUT]))
        along, _ = layup.stresses(thickness, values[..., IN_PLANE], values[..., ABOUT])
        shear = max(shear, float(across.max()))
        pressure = max(pressure, _pressure(direct + bent, along))
    return InSandwich(shear, pressure, wrinkling)


def _pressure(normal: Array, shear: Array) -> float:
    """The largest principal pressure, by pressure on a section and shear along it."""
    return float((0.5 * normal + np.hypot(0.5 * normal, shear)).max())
