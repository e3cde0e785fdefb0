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
from orishell.numerics.arrays import Array, Booleans, Integers
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


LEAST = 1e-3
"""Where no board is, bending is at least that of a membrane with this share of a board's E t."""

SAMPLES = np.array([[4, 1, 1], [1, 4, 1], [1, 1, 4], [2, 2, 2], [0.5, 2.75, 2.75]])
SAMPLES = np.concatenate([SAMPLES, np.roll(SAMPLES[-1:], 1, 1), np.roll(SAMPLES[-1:], 2, 1)]) / 6
"""Places in a triangle, by its corners, at which boards are looked for."""


def panel_sections(
    structure: Structure,
    build: PanelSpec | None,
    boards: Boards | None,
    flat: Array,
    panels: Integers,
) -> Section:
    """Sections of the triangles of meshed panels.

    Gaps and chamfers of solid panels are not taken off.

    build: What panels are made of; None if they are of ``structure.thickness``.
    boards: The boards of a sandwich, numbered by the same panels.
    flat: Corners (T, 3, 2) of the triangles in the flat sheet.
    panels: The panel (T,) of each.
    """
    modulus, nu = structure.modulus, structure.poisson
    if build is None or boards is None or build.construction == "bevel":
        thickness = structure.thickness if build is None else build.thickness
        assert thickness is not None
        return Section.solid(modulus, thickness, nu)
    board = 0.5 * (build.thickness - build.membrane)
    away = 0.5 * (board + build.membrane)
    top, bottom = (_covered(boards.chosen(boards.sides == side), flat, panels) for side in (1, -1))
    number = top.astype(np.int64) + bottom  # boards (T, S) at every place
    plane, fabric = (each / (1 - nu**2) for each in (modulus, structure.membrane_modulus))
    alone = plane * board**3 / 12
    bending = np.choose(number, [0.0, alone, 2 * (alone + plane * board * away**2)])
    between = fabric * build.membrane
    return Section(
        membrane=(plane * board * number).mean(axis=1) + between,
        bending=bending.mean(axis=1) + max(between, LEAST * plane * board) * build.membrane**2 / 12,
        poisson=nu,
        modulus=modulus,
        reach=np.where(number.mean(axis=1) > 1, 0.5 * build.thickness, 0.5 * board),
    )


def _covered(boards: Boards, flat: Array, panels: Integers) -> Booleans:
    """Whether a board covers places (T, S) of the triangles; every panel has one at most."""
    count = int(panels.max()) + 1
    outline = np.zeros((count, boards.outlines.shape[2], 2))
    outline[boards.panels] = boards.outlines[:, 0, :, :2]
    side = np.roll(outline, -1, axis=1) - outline
    places = np.einsum("sk,tkx->tsx", SAMPLES, flat)
    covered = np.ones(places.shape[:2], dtype=bool)
    for corner in range(outline.shape[1]):
        x, y = np.moveaxis(places - outline[panels, corner][:, None], -1, 0)
        along = side[panels, corner][:, None]
        covered &= along[..., 0] * y >= along[..., 1] * x
    present = np.zeros(count, dtype=bool)
    present[boards.panels] = True
    return covered & present[panels][:, None]
