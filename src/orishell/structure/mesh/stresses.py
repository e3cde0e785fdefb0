"""Membrane forces and moments of triangles, and the stresses of panels that follow from them.

Corners of panels, feet and ties are singular points: stress there grows without limit as cells
shrink. So stress is taken from membrane forces n and moments m that are averaged over patches whose
size cells do not change. A patch is a sixteenth of a panel, a quarter of its sides long and wide;
at its corners it is a quarter of the panel. With the mean stiffness of the sections in the patch, A
in its plane and D in bending, both times 1 - nu^2 over E, stresses at the faces are

    n/A -+ m z/D,

z the distance of the outermost fibres: n/t -+ 6 m/t^2 in a solid panel of thickness t. Shear across
the plane follows from how moments change along it, and is averaged likewise.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.plane import tensors_along, vectors_along
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import SheetMesh
from orishell.structure.mesh.triangle import (
    CORNERS,
    IN_PLANE,
    OUT_OF_PLANE,
    Facets,
    curvatures,
    strains,
)

PATCHES = 4
"""Patches along each side of a panel."""


@record
class FacetForces:
    """What triangles bear, in their own axes, on average."""

    forces: Array  # membrane forces xx, yy, xy (T, 3) (force per length)
    moments: Array  # moments xx, yy, xy (T, 3), by how they stretch the upper face (force)
    at_corners: Array  # these moments at all corners (T, 3, 3), as they change linearly (force)


def von_mises(stresses: Array) -> Array:
    """Von Mises' stress (...) of stresses xx, yy, xy (..., 3)."""
    x, y, xy = np.moveaxis(stresses, -1, 0)
    return np.asarray(np.sqrt(x**2 - x * y + y**2 + 3 * xy**2))


@record
class PanelStresses:
    """Stresses of panels by patches, in the panels' axes."""

    patches: Integers  # the patch (T,) of every triangle, as places in the rows of the others
    panels: Integers  # the panel (P,) of every patch
    # stresses xx, yy, xy (P, 3) that both faces have, and what bending adds at the upper one and
    # takes off at the lower one (force per area)
    direct: Array
    bent: Array
    # shear across the plane on sections square to x and y (P, 2), over the thickness there, that of
    # the core and half of each face where there is one (force per area)
    across: Array

    @property
    def faces(self) -> Array:
        """Stresses xx, yy, xy (P, 2, 3) at the lower and the upper face (force per area)."""
        return np.stack([self.direct - self.bent, self.direct + self.bent], axis=1)

    def von_mises(self) -> Array:
        """Von Mises' stress (T, 2) at both faces, that of its patch for every triangle."""
        return von_mises(self.faces)[self.patches]

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
    softness = np.broadcast_to(section.softness, len(flat))
    bend = np.stack(
        [
            np.einsum(
                "tij,tj->ti",
                curvatures(flat, place, softness),
                local[..., OUT_OF_PLANE].reshape(-1, 9),
            )
            for place in CORNERS
        ],
        axis=1,
    )
    # Both matrices are symmetric.
    forces = (stretch[:, None] @ section.in_plane)[:, 0]
    at_corners = bend @ section.in_bending
    # They are linear, so their mean is that in the middle.
    return FacetForces(forces, at_corners.mean(axis=1), at_corners)


def panel_stresses(mesh: SheetMesh, section: Section, found: FacetForces) -> PanelStresses:
    """Stresses of panels, averaged over patches."""
    count, *cells = mesh.nodes.shape[0], mesh.nodes.shape[1] - 1, mesh.nodes.shape[2] - 1
    areas = mesh.facets.areas()
    left, end, top = (
        _places(mesh, side) for side in (np.s_[:, :, 0], np.s_[:, :, -1], np.s_[:, 0])
    )
    # Lines of nodes that cut a panel are on average where they are in its middle.
    down, right = _overlaps(0.5 * (left + end)), _overlaps(top)
    turns = turns_in_panels(mesh)
    amounts = np.concatenate(
        [
            tensors_along(found.forces, *turns),
            tensors_along(found.moments, *turns),
            _shears(mesh, found.at_corners),
            *(
                np.broadcast_to(np.asarray(each, np.float64), len(areas))[:, None]
                for each in (section.membrane, section.bending, section.reach, section.depth, 1.0)
            ),
        ],
        axis=1,
    )
    by_cell = (areas[:, None] * amounts).reshape(count, *cells, 2, -1).sum(axis=3)
    sums = np.einsum("fai,fbj,fijc->fabc", down, right, by_cell)
    half = PATCHES // 2
    quarters = sums.reshape(count, 2, half, 2, half, -1).sum(axis=(2, 4))
    sums[:, :: PATCHES - 1, :: PATCHES - 1] = quarters
    mean = (sums / sums[..., -1:]).reshape(count * PATCHES**2, -1)
    plane = section.modulus / (1 - section.poisson**2)
    membrane, bending, reach, depth = (mean[:, k : k + 1] for k in range(8, 12))
    main = (
        np.arange(count)[:, None, None] * PATCHES**2
        + down.argmax(axis=1)[:, :, None] * PATCHES
        + right.argmax(axis=1)[:, None]
    )
    return PanelStresses(
        patches=np.repeat(main.ravel(), 2),
        panels=np.repeat(np.arange(count), PATCHES**2),
        direct=plane * mean[:, :3] / membrane,
        bent=plane * mean[:, 3:6] * reach / bending,
        across=mean[:, 6:8] / depth,
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


def _shears(mesh: SheetMesh, at_corners: Array) -> Array:
    """Shear across the plane of triangles (T, 2), on sections square to x and y of their panels.

    Where moments m are in balance, Q_x = m_xx,x + m_xy,y and Q_y = m_xy,x + m_yy,y. Within a
    triangle slopes of m do not converge: at nodes m is averaged over the triangles of a panel.
    """
    cosines, sines = (each[:, None] for each in turns_in_panels(mesh))
    moments = tensors_along(at_corners, cosines, sines)
    areas = np.broadcast_to(mesh.facets.areas()[:, None], mesh.places.shape)
    size = mesh.nodes.size
    total = np.bincount(mesh.places.ravel(), areas.ravel(), size)
    mean = np.stack(
        [
            np.bincount(mesh.places.ravel(), (areas * each).ravel(), size) / total
            for each in np.moveaxis(moments, -1, 0)
        ],
        axis=1,
    )[mesh.places]
    # Slopes, in axes of triangles, of what is linear between their corners.
    flat = mesh.facets.flat()
    change = np.linalg.solve(flat[:, 1:], mean[:, 1:] - mean[:, :1]).swapaxes(1, 2)
    along = vectors_along(np.asarray(change, np.float64), cosines, sines)
    xx, yy, xy = np.moveaxis(along, 1, 0)
    return np.stack([xx[:, 0] + xy[:, 1], xy[:, 0] + yy[:, 1]], axis=1)


def turns_in_panels(mesh: SheetMesh) -> tuple[Array, Array]:
    """Cosines and sines (T,) of the turn from triangles' axes to those of their panels' first."""
    axes = mesh.facets.axes()
    own = axes[:: len(axes) // len(mesh.nodes), 0][mesh.panels]
    c, s = (np.einsum("tx,tx->t", own, axes[:, k]) for k in (0, 1))
    return c, s
