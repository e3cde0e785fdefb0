"""Membrane forces and moments of triangles, and the stresses of panels that follow from them.

Corners of panels, feet and ties are singular points: stress there grows without limit as cells
shrink. So stress is taken from membrane forces n and moments m that are averaged over patches whose
size cells do not change. A patch is a sixteenth of a panel, a quarter of its sides long and wide;
at its corners it is a quarter of the panel. With the mean stiffness of the sections in the patch, A
in its plane and D in bending, both times 1 - nu^2 over E, stresses at the faces are

    n/A -+ m z/D,

z the distance of the outermost fibres: n/t -+ 6 m/t^2 in a solid panel of thickness t.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import SheetMesh
from orishell.structure.mesh.triangle import IN_PLANE, OUT_OF_PLANE, Facets, curvatures, strains

MIDDLE = 1 / 3, 1 / 3
PATCHES = 4
"""Patches along each side of a panel."""


@record
class FacetForces:
    """What triangles bear, in their own axes, on average."""

    forces: Array  # membrane forces xx, yy, xy (T, 3) (force per length)
    moments: Array  # moments xx, yy, xy (T, 3), by how they stretch the upper face (force)


@record
class PanelStresses:
    """Stresses of panels by patches, in the panels' axes."""

    patches: Integers  # the patch (T,) of every triangle, as places in the rows of the others
    faces: Array  # stresses xx, yy, xy (P, 2, 3) at the lower and the upper face (force per area)

    def von_mises(self) -> Array:
        """Von Mises' stress (T, 2) at both faces, that of its patch for every triangle."""
        x, y, xy = np.moveaxis(self.faces, -1, 0)
        return np.asarray(np.sqrt(x**2 - x * y + y**2 + 3 * xy**2)[self.patches])

    def principal(self) -> Array:
        """The largest and the least principal stress (T, 2), of both faces."""
        x, y, xy = np.moveaxis(self.faces, -1, 0)
        middle, radius = 0.5 * (x + y), np.hypot(0.5 * (x - y), xy)
        both = np.stack([(middle + radius).max(axis=1), (middle - radius).min(axis=1)], axis=1)
        return np.asarray(both[self.patches])


def facet_stresses(facets: Facets, section: Section, moved: Array) -> FacetForces:
    """What triangles bear.

    moved: Displacements and rotations (T, 18) of their corners.
    """
    flat = facets.flat()
    local = np.einsum("tij,tkj->tki", facets.axes(), moved.reshape(-1, 6, 3)).reshape(-1, 3, 6)
    stretch = np.einsum("tij,tj->ti", strains(flat), local[..., IN_PLANE].reshape(-1, 9))
    # Curvatures are linear, so their mean is that in the middle.
    bend = np.einsum(
        "tij,tj->ti", curvatures(flat, MIDDLE), local[..., OUT_OF_PLANE].reshape(-1, 9)
    )
    plane = section.matrix(1.0)
    membrane, bending = (
        np.broadcast_to(np.asarray(each, np.float64), len(flat))[:, None]
        for each in (section.membrane, section.bending)
    )
    return FacetForces(membrane * (stretch @ plane), bending * (bend @ plane))


def panel_stresses(mesh: SheetMesh, section: Section, found: FacetForces) -> PanelStresses:
    """Stresses of panels, averaged over patches."""
    count, cells = len(mesh.nodes), mesh.nodes.shape[1] - 1
    areas = mesh.facets.areas()
    down, right = (_overlaps(_places(mesh, side)) for side in (np.s_[:, :, 0], np.s_[:, 0]))
    amounts = np.concatenate(
        [
            _turned(mesh, found.forces),
            _turned(mesh, found.moments),
            *(
                np.broadcast_to(np.asarray(each, np.float64), len(areas))[:, None]
                for each in (section.membrane, section.bending, section.reach, 1.0)
            ),
        ],
        axis=1,
    )
    by_cell = (areas[:, None] * amounts).reshape(count, cells, cells, 2, -1).sum(axis=3)
    sums = np.einsum("fai,fbj,fijc->fabc", down, right, by_cell)
    half = PATCHES // 2
    quarters = sums.reshape(count, 2, half, 2, half, -1).sum(axis=(2, 4))
    sums[:, :: PATCHES - 1, :: PATCHES - 1] = quarters
    mean = (sums / sums[..., -1:]).reshape(count * PATCHES**2, -1)
    plane = section.modulus / (1 - section.poisson**2)
    direct = plane * mean[:, :3] / mean[:, 6:7]
    bent = plane * mean[:, 3:6] * mean[:, 8:9] / mean[:, 7:8]
    main = (
        np.arange(count)[:, None, None] * PATCHES**2
        + down.argmax(axis=1)[:, :, None] * PATCHES
        + right.argmax(axis=1)[:, None]
    )
    return PanelStresses(
        np.repeat(main.ravel(), 2), np.stack([direct - bent, direct + bent], axis=1)
    )


def _places(mesh: SheetMesh, side: tuple[slice | int, ...]) -> Array:
    """Places (F, cells+1) of nodes along a side of panels, from 0 to 1."""
    points = mesh.facets.points[mesh.seats[side]]
    away = np.linalg.norm(points - points[:, :1], axis=-1)
    return np.asarray(away / away[:, -1:])


def _overlaps(places: Array) -> Array:
    """Shares (F, P, cells) of cells between places (F, cells+1) that are in every patch."""
    start = np.arange(PATCHES)[:, None] / PATCHES
    low = np.maximum(places[:, None, :-1], start)
    high = np.minimum(places[:, None, 1:], start + 1 / PATCHES)
    return np.asarray(np.maximum(high - low, 0.0) / np.diff(places)[:, None])


def _turned(mesh: SheetMesh, tensors: Array) -> Array:
    """Tensors xx, yy, xy (T, 3) in the axes of triangles, in those of their panels' first one."""
    axes = mesh.facets.axes()
    own = axes[:: len(axes) // len(mesh.nodes), 0][mesh.panels]
    c, s = (np.einsum("tx,tx->t", own, axes[:, k]) for k in (0, 1))
    x, y, xy = tensors.T
    turned = [c * c * x + s * s * y + 2 * s * c * xy, s * s * x + c * c * y - 2 * s * c * xy]
    return np.stack([*turned, s * c * (y - x) + (c * c - s * s) * xy], axis=1)
