"""What is shown over a shell: the surface that it follows, and how far its vertices are from it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from orishell.design import Design
from orishell.deviation import measure_points
from orishell.document import Document

Array = NDArray[np.float64]

CELLS = 40
"""Cells of the lattice along the surface's longer side, about."""
FLAT = 200
"""Cells leave the surface by a step over this, about."""
MOST_CELLS = 40_000
"""Cells of the lattice at most."""


def lay_surface(document: Document, design: Design, *, measured: bool = True) -> Document:
    """The document of a design with its surface; as it is if the design has none.

    Parameters
    ----------
    document, design
        The design.
    measured
        Whether the distances of its vertices from the surface at lock are measured too.
    """
    if design.swept is None:
        return document
    surface = design.surface
    step = surface.size() / CELLS
    lattice = surface.lattice(step, step / FLAT, most=MOST_CELLS)
    document = replace(document, surface=lattice.points)
    if not measured:
        return document
    grid, inner = design.mechanism.grid, design.mechanism.inner_columns
    shell = document.last.positions.reshape(grid.rows, grid.columns, 3)
    distances = np.full((grid.rows, grid.columns), np.nan)
    distances[:, inner] = measure_points(shell[:, inner], surface)
    return replace(document, distances=distances.ravel())
