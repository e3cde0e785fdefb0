"""Sections of panels: how stiff they are, and how far their outermost fibres are away.

A solid panel of thickness t has E t and E t^3/12, each over 1 - nu^2. Of two boards of thickness b
at a distance 2 d between their middles each adds E b and E (b^3/12 + b d^2); where only one of them
is left beside a crease, E b and E b^3/12. A membrane between them adds what it has by itself.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.design import PanelSpec
from orishell.motion.boards import Boards
from orishell.numerics.arrays import Array, Booleans
from orishell.structure.settings import Structure


@record
class Section:
    """Sections of triangles (T,), or one for all, isotropic."""

    # force per length by strain (T,), E t/(1 - nu^2) of a solid plate (force per length)
    membrane: ArrayLike
    # moment per length by curvature (T,), E t^3/12/(1 - nu^2) of a solid plate (force times length)
    bending: ArrayLike
    poisson: float  # Poisson's ratio
    modulus: float  # Young's modulus at the outermost fibres (force per area)
    reach: ArrayLike  # distance (T,) of the outermost fibres from the middle (length)

    @classmethod
    def solid(cls, modulus: float, thickness: float, poisson: float) -> Section:
        """That of a solid plate: modulus (force per area), thickness (length), poisson's ratio."""
        plane = modulus / (1 - poisson**2)
        bending = plane * thickness**3 / 12
        return cls(plane * thickness, bending, poisson, modulus, 0.5 * thickness)

    def matrix(self, stiffness: ArrayLike) -> Array:
        """The matrices (..., 3, 3) of plane stress with one of its two, a stiffness (...)."""
        nu = self.poisson
        plane = np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])
        return np.asarray(np.asarray(stiffness, np.float64)[..., None, None] * plane)


LEAST_BENDING = 1e-3
"""Where no board is, bending is at least that of a membrane with this share of a board's E t."""

SAMPLES, WINDOW = 64, 16
"""Places along a side of a panel at which boards are looked for, and over how many of them what is
found is averaged, along both sides."""


def panel_sections(
    structure: Structure,
    build: PanelSpec | None,
    boards: Boards | None,
    flat: Array,
    centres: Array,
) -> Section:
    """Sections of the triangles of meshed panels.

    Gaps and chamfers of solid panels are not taken off. Boards are averaged over a quarter of the
    width of a panel, so that sections are the same whatever the mesh, and where corners have no
    board a vertex still hangs on what is beside it.

    build: What panels are made of; None if they are of ``structure.thickness``.
    boards: The boards of a sandwich, numbered by the same panels.
    flat: Corners (F, 4, 2) of the panels in the flat sheet.
    centres: Middles (F, t, 2) of the panels' triangles, as shares of the way down and across.
    """
    modulus, nu = structure.modulus, structure.poisson
    if build is None or boards is None or build.is_solid:
        thickness = structure.thickness if build is None else build.thickness
        assert thickness is not None
        return Section.solid(modulus, thickness, nu)
    board = 0.5 * (build.thickness - build.membrane)
    away = 0.5 * (board + build.membrane)
    places = places_in(flat, SAMPLES)
    top, bottom = (_covered(boards.chosen(boards.sides == side), places) for side in (1, -1))
    number = top.astype(np.int64) + bottom  # boards (F, S, S) at every place
    plane, fabric = (each / (1 - nu**2) for each in (modulus, structure.membrane_modulus))
    alone = plane * board**3 / 12
    bends = np.choose(number, [0.0, alone, 2 * (alone + plane * board * away**2)])
    boards_there = _averaged(number.astype(np.float64), centres)
    bending = _averaged(np.asarray(bends, np.float64), centres)
    between = fabric * build.membrane
    return Section(
        membrane=plane * board * boards_there + between,
        bending=bending + max(between, LEAST_BENDING * plane * board) * build.membrane**2 / 12,
        poisson=nu,
        modulus=modulus,
        reach=np.where(boards_there > 1, 0.5 * build.thickness, 0.5 * board),
    )


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
