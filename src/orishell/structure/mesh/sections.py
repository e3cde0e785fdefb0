"""Sections of panels: how stiff they are, and how far their outermost fibres are away.

Chamfers leave a solid board the thinner the nearer to a crease, down to half of it or less.

A board has what its layup has. Of two boards at a distance 2 d between their middles each adds its
E A and E (I + A d^2); where only one of them is left beside a crease, E A and E I. A membrane
between them adds what it has by itself.
"""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.design import PanelSpec
from orishell.motion.boards import Boards
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.structure.mesh.layup import Layup
from orishell.structure.settings import Structure


@record
class Section:
    """Sections of triangles (T,), or one for all, isotropic unless they have a grain."""

    # force per length by strain (T,), E t/(1 - nu^2) of a solid plate (force per length)
    membrane: ArrayLike
    # moment per length by curvature (T,), E t^3/12/(1 - nu^2) of a solid plate (force times length)
    bending: ArrayLike
    poisson: float  # Poisson's ratio
    modulus: float  # Young's modulus at the outermost fibres (force per area)
    reach: ArrayLike  # distance (T,) of the outermost fibres from the middle (length)
    depth: ArrayLike  # over how much shear across the plane is spread (T,) (length)
    # force per length by shear strain across the plane (T,); infinite where it does not count
    shear: ArrayLike = np.inf
    # how forces and moments go with strains and curvatures (T, 3, 3), in the axes of triangles, of
    # boards with a grain; times membrane and bending
    grain_in_plane: Array | None = None
    grain_in_bending: Array | None = None

    @property
    def softness(self) -> Array:
        """Bending stiffness by that in shear (T,), or (); 0 where shear does not count."""
        return np.asarray(np.asarray(self.bending) / np.asarray(self.shear), np.float64)

    @classmethod
    def solid(cls, modulus: float, thickness: float, poisson: float) -> Section:
        """That of a solid plate: modulus (force per area), thickness (length), poisson's ratio."""
        return cls.board(Layup(modulus, poisson), thickness)

    @classmethod
    def board(cls, layup: Layup, thickness: float) -> Section:
        """That of a board of a layup and a thickness (length)."""
        return cls(
            membrane=layup.plane * float(layup.area(thickness)),
            bending=layup.plane * float(layup.inertia(thickness)),
            poisson=layup.poisson,
            modulus=layup.modulus,
            reach=0.5 * thickness,
            depth=float(layup.depth(thickness)),
            shear=float(layup.shear(thickness)),
        )

    def of(self, triangles: Integers) -> Section:
        """Those of some triangles (t,)."""
        values = ((each.name, getattr(self, each.name)) for each in fields(self))
        return replace(self, **{name: each[triangles] for name, each in values if np.ndim(each)})

    @property
    def in_plane(self) -> Array:
        """Forces per length by strains xx, yy, xy (T, 3, 3), or (3, 3)."""
        return self.matrix(self.membrane, self.grain_in_plane)

    @property
    def in_bending(self) -> Array:
        """Moments per length by curvatures xx, yy and twice xy (T, 3, 3), or (3, 3)."""
        return self.matrix(self.bending, self.grain_in_bending)

    def matrix(self, stiffness: ArrayLike, grain: Array | None = None) -> Array:
        """The matrices (..., 3, 3) of plane stress with a stiffness (...), or those of a grain."""
        nu = self.poisson
        plane = np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])
        own = plane if grain is None else grain
        return np.asarray(np.asarray(stiffness, np.float64)[..., None, None] * own)


LEAST_BENDING = 1e-3
"""Where no board is, bending is at least that of a membrane with this share of a board's E t."""

NO_CHAMFER = 1e-300
"""Divides where there is no chamfer, so that a board is as thick as it is."""
SAMPLES, WINDOW = 64, 16
"""Places along a side of a panel at which boards are looked for, and over how many of them what is
found is averaged, along both sides."""


def panel_sections(
    structure: Structure,
    build: PanelSpec | None,
    boards: Boards | None,
    flat: Array,
    centres: Array,
    *,
    joined: float = 0.0,
) -> Section:
    """Sections of the triangles of meshed panels.

    Boards are averaged over a quarter of the width of a panel, so that sections are the same
    whatever the mesh, and where corners have no board a vertex still hangs on what is beside it.

    build: What panels are made of; None if they are of ``structure.thickness``.
    boards: Their boards, numbered by the same panels.
    flat: Corners (F, 4, 2) of the panels in the flat sheet.
    centres: Middles (F, t, 2) of the panels' triangles, as shares of the way down and across.
    joined: Where nothing is known of a membrane, panels are in their plane as stiff as so many
        boards at least.
    """
    layup = structure.layup
    if build is None or boards is None or build.is_solid:
        thickness = structure.thickness if build is None else build.thickness
        assert thickness is not None
        if build is None or boards is None or build.construction != "bevel":
            return Section.board(layup, thickness)
        return _tapered(layup, thickness, boards, flat, centres)
    board = 0.5 * (build.thickness - build.membrane)
    away = 0.5 * (board + build.membrane)
    places = places_in(flat, SAMPLES)
    top, bottom = (_covered(boards.chosen(boards.sides == side), places) for side in (1, -1))
    number = top.astype(np.int64) + bottom  # boards (F, S, S) at every place
    one, alone = (layup.plane * float(each(board)) for each in (layup.area, layup.inertia))
    fabric = structure.membrane_modulus / (1 - layup.poisson**2)
    bends = np.choose(number, [0.0, alone, 2 * (alone + one * away**2)])
    boards_there = _averaged(number.astype(np.float64), centres)
    bending = _averaged(np.asarray(bends, np.float64), centres)
    between = fabric * build.membrane
    both = boards_there > 1
    held = boards_there if between else np.maximum(boards_there, joined)
    return Section(
        membrane=one * held + between,
        bending=bending + max(between, LEAST_BENDING * one) * build.membrane**2 / 12,
        poisson=layup.poisson,
        modulus=layup.modulus,
        reach=np.where(both, 0.5 * build.thickness, 0.5 * board),
        depth=np.where(both, 2, 1) * float(layup.depth(board)),
        shear=np.maximum(boards_there, LEAST_BENDING) * float(layup.shear(board)),
    )


def whole_section(structure: Structure, build: PanelSpec | None) -> Section:
    """The section of a plate that is made as panels are, where no crease is near."""
    layup = structure.layup
    if build is None or build.is_solid:
        thickness = structure.thickness if build is None else build.thickness
        assert thickness is not None
        return Section.board(layup, thickness)
    board = 0.5 * (build.thickness - build.membrane)
    away = 0.5 * (board + build.membrane)
    one, alone = (layup.plane * float(each(board)) for each in (layup.area, layup.inertia))
    between = structure.membrane_modulus / (1 - layup.poisson**2) * build.membrane
    return Section(
        membrane=2 * one + between,
        bending=2 * (alone + one * away**2) + between * build.membrane**2 / 12,
        poisson=layup.poisson,
        modulus=layup.modulus,
        reach=0.5 * build.thickness,
        depth=2 * float(layup.depth(board)),
        shear=2 * float(layup.shear(board)),
    )


def _tapered(
    layup: Layup, thickness: float, boards: Boards, flat: Array, centres: Array
) -> Section:
    """Sections of boards that are chamfered.

    Each place bends about the middle of what is left of it there, apart from its neighbours: that
    is the least that it may be, and about the hinge plane it is up to four times as stiff.
    """
    whole = Section.board(layup, thickness)
    left = thickness_left(boards, flat, SAMPLES)
    area, inertia = (
        _averaged(each(thickness * left), centres) / float(each(thickness))
        for each in (layup.area, layup.inertia)
    )
    share = np.maximum(_averaged(left, centres), LEAST_BENDING)
    return Section(
        membrane=np.asarray(whole.membrane) * np.maximum(area, LEAST_BENDING),
        bending=np.asarray(whole.bending) * np.maximum(inertia, LEAST_BENDING),
        poisson=layup.poisson,
        modulus=layup.modulus,
        reach=np.asarray(whole.reach) * share,
        depth=layup.depth(thickness * share),
        shear=layup.shear(thickness * share),
    )


def thickness_left(boards: Boards, flat: Array, samples: int) -> Array:
    """The share (F, S, S) that chamfers leave of the thickness of solid boards; 0 beside them.

    flat: Corners (F, 4, 2) of the panels in the flat sheet, counter-clockwise.
    """
    there, (low, middle, top) = boards.panels, (set_back(boards, flat, k) for k in range(3))
    own, (across, _) = flat[there], inwards(flat[there])
    from_edges = places_in(own, samples)[:, :, :, None] - own[:, None, None]
    deep = np.einsum("fabsx,fsx->fabs", from_edges, across) - middle[there, None, None]
    thick = np.zeros(deep.shape[:3])
    for back in (low, top):
        wide = np.maximum(back[there] - middle[there], NO_CHAMFER)
        thick += 0.5 * np.clip(deep / wide[:, None, None], 0.0, 1.0).min(axis=-1)
    left = np.zeros((len(flat), samples, samples))
    left[there] = thick * (deep >= 0).all(axis=-1)
    return left


def inwards(flat: Array) -> tuple[Array, Array]:
    """Directions (F, 4, 2) into panels from their edges, and lengths (F, 4) of these."""
    along = np.roll(flat, -1, axis=1) - flat
    length = np.linalg.norm(along, axis=-1)
    return np.stack([-along[..., 1], along[..., 0]], axis=-1) / length[..., None], length


def set_back(boards: Boards, flat: Array, level: int) -> Array:
    """How far boards stand back from edges (F, 4) at a level of theirs; infinite without one."""
    across, _ = inwards(flat)
    back = np.full(flat.shape[:2], np.inf)
    away = boards.outlines[:, level, None, :, :2] - flat[boards.panels][:, :, None]
    back[boards.panels] = np.einsum("bskx,bsx->bsk", away, across[boards.panels]).min(axis=-1)
    return back


def places_in(flat: Array, samples: int) -> Array:
    """Places (F, S, S, 2) in panels with corners (F, 4, 2), downwards and to the right."""
    share = (np.arange(samples) + 0.5) / samples
    down, right = share[:, None, None], share[:, None]
    a, b, c, d = (each[:, None, None] for each in flat.swapaxes(0, 1))
    return np.asarray(
        (a * (1 - right) + d * right) * (1 - down) + (b * (1 - right) + c * right) * down
    )


def _averaged(found: Array, centres: Array) -> Array:
    """Means (T,) of what is found at places (F, S, S), about middles of triangles (F, t, 2)."""
    total = np.pad(found.cumsum(axis=1).cumsum(axis=2), ((0, 0), (1, 0), (1, 0)))
    first = np.clip(np.rint(centres * SAMPLES - WINDOW / 2), 0, SAMPLES - WINDOW).astype(np.int64)
    top, left = np.moveaxis(first, -1, 0)
    bottom, right, panel = top + WINDOW, left + WINDOW, np.arange(len(found))[:, None]
    inside = total[panel, bottom, right] - total[panel, top, right]
    inside += total[panel, top, left] - total[panel, bottom, left]
    return np.asarray(inside / WINDOW**2).ravel()


def _covered(boards: Boards, places: Array) -> Booleans:
    """Whether a board covers places (F, S, S, 2) of panels; every panel has one at most."""
    count = len(places)
    outline = np.zeros((count, boards.outlines.shape[2], 2))
    outline[boards.panels] = boards.outlines[:, 0, :, :2]
    side = np.roll(outline, -1, axis=1) - outline
    covered = np.ones(places.shape[:3], dtype=bool)
    for corner in range(outline.shape[1]):
        x, y = np.moveaxis(places - outline[:, corner, None, None], -1, 0)
        along = side[:, corner, None, None]
        covered &= along[..., 0] * y >= along[..., 1] * x
    present = np.zeros(count, dtype=bool)
    present[boards.panels] = True
    return covered & present[:, None, None]
